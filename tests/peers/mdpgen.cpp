// Numbers the states of a Cleanup World as src/domain/dynamics.rs has it, apart from that, and writes them as an
// explicit MDP. Reads the flat text of worlds.py on standard input: see `read`.
//   mdpgen [OUT.drn [PREFIX]]   prints counts and V(start); writes Storm's explicit format, and flat arrays for numpy.
// A name with "sink" in it: discounting as a step to a sink with 1 - γ, for reachability; else a reward for entering the goal.
// A state keeps the robot's heading only where it faces an object (only `pull` sees it). Goal states are absorbing.
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <iostream>
#include <string>
#include <vector>
using namespace std;
typedef uint64_t Key;
static int W, H, nd, no, pull;
static double slip_, lock_, loss_;
static vector<int> grid;           // per cell: -2 wall, -1 floor, else the door
static int dx[4] = {0, 0, 1, -1}, dy[4] = {1, -1, 0, 0}, opp[4] = {1, 0, 3, 2};
struct Part { int who, l, b, r, t; };  // who: -1 the robot, else an object; strictly inside the bounds
static vector<Part> goal;
struct S { int a, d, o[8], k[16]; };
static Key pack(const S &s) {
    Key k = s.d;
    k = k << 10 | s.a;
    for (int i = 0; i < no; i++) k = k << 10 | s.o[i];
    for (int i = 0; i < nd; i++) k = k << 2 | s.k[i];
    return k;
}
static S unpack(Key k) {
    S s;
    for (int i = nd; i-- > 0; k >>= 2) s.k[i] = k & 3;
    for (int i = no; i-- > 0; k >>= 10) s.o[i] = k & 1023;
    s.a = k & 1023;
    s.d = k >> 10;
    return s;
}
static int at(const S &s, int c) {
    for (int i = 0; i < no; i++) if (s.o[i] == c) return i;
    return -1;
}
static int next_cell(int c, int d) {
    int x = c % W + dx[d], y = c / W + dy[d];
    if (x < 0 || y < 0 || x >= W || y >= H) return -1;
    return y * W + x;
}
static bool open_(const S &s, int c) { return c >= 0 && grid[c] != -2 && (grid[c] < 0 || s.k[grid[c]] != 1); }
static Key canon(S s) {
    if (!pull) s.d = 0;
    else if (s.d < 4) {
        int c = next_cell(s.a, s.d);
        if (c < 0 || at(s, c) < 0) s.d = 4;
    }
    return pack(s);
}
struct Out { Key k; double p; };
static void add(vector<Out> &v, Key k, double p) {
    if (p <= 0) return;
    for (auto &o : v) if (o.k == k) { o.p += p; return; }
    v.push_back({k, p});
}
// Action 0 to 3: north south east west; 4: pull.
static void outcomes(const S &s, int a, vector<Out> &out) {
    out.clear();
    add(out, canon(s), slip_);
    double left = 1 - slip_;
    S still = s, moved = s;
    int entered[2] = {-1, -1};
    bool carries = false;
    if (a < 4) {
        still.d = moved.d = a;
        int c = next_cell(s.a, a);
        if (open_(s, c)) {
            int o = at(s, c);
            if (o < 0) { moved.a = c; entered[0] = c; }
            else {
                int e = next_cell(c, a);
                if (open_(s, e) && at(s, e) < 0) {
                    moved.a = c; moved.o[o] = e; entered[0] = c; entered[1] = e; carries = true;
                }
            }
        }
    } else if (s.d < 4) {
        int c = next_cell(s.a, s.d), o = c < 0 ? -1 : at(s, c);
        if (o >= 0 && open_(s, c) && open_(s, s.a)) {
            moved.a = c; moved.o[o] = s.a; moved.d = opp[s.d]; entered[0] = c; entered[1] = s.a; carries = true;
        }
    }
    for (int e : entered) {
        if (e < 0 || grid[e] < 0 || still.k[grid[e]] != 0) continue;
        S locked = still;
        locked.k[grid[e]] = 1;
        add(out, canon(locked), left * lock_);
        still.k[grid[e]] = moved.k[grid[e]] = 2;
        left *= 1 - lock_;
    }
    if (carries) { add(out, canon(still), left * loss_); left *= 1 - loss_; }
    add(out, canon(moved), left);
}
static bool is_goal(const S &s) {
    for (auto &g : goal) {
        int c = g.who < 0 ? s.a : s.o[g.who], x = c % W, y = c / W;
        if (!(g.l < x && x < g.r && g.b < y && y < g.t)) return false;
    }
    return true;
}
static double cpu() { timespec t; clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t); return t.tv_sec + t.tv_nsec / 1e9; }
int main(int n, char **v) {
    S s;
    cin >> W >> H >> nd >> no >> pull >> slip_ >> lock_ >> loss_;
    grid.resize(W * H);
    for (auto &g : grid) cin >> g;
    for (int i = 0; i < nd; i++) cin >> s.k[i];   // 0 unknown, 1 locked, 2 unlocked
    cin >> s.a >> s.d;
    for (int i = 0; i < no; i++) cin >> s.o[i];
    int ng;
    cin >> ng;
    goal.resize(ng);
    for (auto &g : goal) cin >> g.who >> g.l >> g.b >> g.r >> g.t;
    if (!cin || 3 + 10 * (1 + no) + 2 * nd > 64) { fprintf(stderr, "bad input\n"); return 2; }
    double t0 = cpu();
    vector<Key> keys;
    vector<uint32_t> table(1 << 16, ~0u);
    auto id = [&](Key k) -> uint32_t {
        if (keys.size() * 2 > table.size()) {
            vector<uint32_t> big(table.size() * 2, ~0u);
            for (uint32_t i = 0; i < keys.size(); i++) {
                size_t h = keys[i] * 0x9E3779B97F4A7C15ull >> 20 & (big.size() - 1);
                while (big[h] != ~0u) h = (h + 1) & (big.size() - 1);
                big[h] = i;
            }
            table.swap(big);
        }
        size_t h = k * 0x9E3779B97F4A7C15ull >> 20 & (table.size() - 1);
        while (table[h] != ~0u) {
            if (keys[table[h]] == k) return table[h];
            h = (h + 1) & (table.size() - 1);
        }
        table[h] = keys.size();
        keys.push_back(k);
        return table[h];
    };
    id(canon(s));
    vector<uint32_t> state_row{0}, row_start{0}, target;
    vector<double> prob;
    vector<char> is_goal_;
    vector<Out> out;
    for (uint32_t i = 0; i < keys.size(); i++) {
        S here = unpack(keys[i]);
        is_goal_.push_back(is_goal(here));
        if (is_goal_[i]) { target.push_back(i); prob.push_back(1); row_start.push_back(target.size()); }
        else for (int a = 0; a < 4 + pull; a++) {
            outcomes(here, a, out);
            if (out.size() == 1 && out[0].k == keys[i] && a) continue;  // an action that does nothing at all is one of them enough
            for (auto &o : out) { uint32_t j = id(o.k); target.push_back(j); prob.push_back(o.p); }
            row_start.push_back(target.size());
        }
        state_row.push_back(row_start.size() - 1);
    }
    size_t N = keys.size(), M = row_start.size() - 1;
    double t1 = cpu();
    // Plain value iteration, for the check alone.
    const double g = 0.99;
    vector<double> val(N, 0);
    int sweeps = 0;
    for (double change = 1; change > 1e-11 && sweeps < 10000; sweeps++) {
        change = 0;
        for (size_t i = 0; i < N; i++) {
            if (is_goal_[i]) continue;
            double best = 0;
            for (uint32_t r = state_row[i]; r < state_row[i + 1]; r++) {
                double sum = 0;
                for (uint32_t e = row_start[r]; e < row_start[r + 1]; e++) sum += prob[e] * (is_goal_[target[e]] ? 1 : g * val[target[e]]);
                best = max(best, sum);
            }
            change = max(change, fabs(best - val[i]));
            val[i] = best;
        }
    }
    printf("states %zu choices %zu transitions %zu build %.3f value %.9f sweeps %d check %.3f\n", N, M, target.size(), t1 - t0, val[0], sweeps, cpu() - t1);
    if (n > 1) {
        FILE *f = fopen(v[1], "w");
        bool sink = string(v[1]).find("sink") != string::npos;
        fprintf(f, "@type: MDP\n@parameters\n\n@reward_models\n%s\n@nr_states\n%zu\n@nr_choices\n%zu\n@model\n", sink ? "" : "r ", N + sink, M + sink);
        for (size_t i = 0; i < N; i++) {
            fprintf(f, "state %zu%s%s%s\n", i, sink ? "" : " [0]", i ? "" : " init", is_goal_[i] ? " goal" : "");
            for (uint32_t r = state_row[i]; r < state_row[i + 1]; r++) {
                double reward = 0, scale = sink && !is_goal_[i] ? g : 1;
                if (!is_goal_[i]) for (uint32_t e = row_start[r]; e < row_start[r + 1]; e++) if (is_goal_[target[e]]) reward += prob[e];
                if (sink) fprintf(f, "\taction %u\n", r - state_row[i]);
                else fprintf(f, "\taction %u [%.17g]\n", r - state_row[i], reward);
                for (uint32_t e = row_start[r]; e < row_start[r + 1]; e++) fprintf(f, "\t\t%u : %.17g\n", target[e], prob[e] * scale);
                if (scale < 1) fprintf(f, "\t\t%zu : %.17g\n", N, 1 - scale);
            }
        }
        if (sink) fprintf(f, "state %zu\n\taction 0\n\t\t%zu : 1\n", N, N);
        fclose(f);
    }
    if (n > 2) {
        auto dump = [&](const char *what, const void *p, size_t bytes) {
            FILE *f = fopen((string(v[2]) + what).c_str(), "wb");
            fwrite(p, 1, bytes, f);
            fclose(f);
        };
        dump(".state_row", state_row.data(), 4 * state_row.size());
        dump(".row_start", row_start.data(), 4 * row_start.size());
        dump(".target", target.data(), 4 * target.size());
        dump(".prob", prob.data(), 8 * prob.size());
        dump(".goal", is_goal_.data(), is_goal_.size());
    }
}
