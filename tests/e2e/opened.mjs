// What all pages of the site have when they are open: elements by their test ids.

export class Opened {
  /** `page` is of the flow `t`. */
  constructor(t, page) {
    this.t = t;
    this.page = page;
  }

  /** The element with this test id. */
  by(id) {
    return this.page.getByTestId(id);
  }

  /** Presses what has this test id. */
  press(id) {
    return this.by(id).click();
  }
}
