//! The one file that knows the GPU: draws a scene's numbers on a canvas, with WebGPU where it proves to work and
//! WebGL 2 elsewhere. A canvas that once had a context of one kind gives none of the other, so WebGPU is tried
//! on a canvas of its own first. Linked by the program `renderer` and by tests alone.
//!
//! The surface's format is a plain (not an sRGB) one: the shader's colours reach the canvas as they are, and
//! blend as the page's own do.

use crate::render::{Quad, Scene};
use futures_channel::oneshot;
use js_sys::{Array, Promise};
use std::cell::Cell;
use std::mem::replace;
use std::sync::{Arc, Mutex, PoisonError};
use wasm_bindgen::prelude::{Closure, JsCast, JsValue};
use wasm_bindgen_futures::{JsFuture, future_to_promise};
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement, Window};

/// How the browser draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Backend {
    /// The newer way.
    WebGpu,
    /// The way that is nearly everywhere.
    WebGl2,
}

/// Why nothing can be drawn.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum GpuError {
    /// The browser has no such backend to give.
    #[error("no adapter: {0}")]
    Missing(String),
    /// The device was there and is gone.
    #[error("the GPU was lost: {0}")]
    Lost(String),
    /// The backend takes pictures and shows nothing.
    #[error("what is drawn does not show")]
    Blank,
    /// The numbers are no scene.
    #[error("not a scene: {0} numbers")]
    NotAScene(usize),
}

/// One canvas and what draws on it.
pub struct Gpu {
    backend: Backend,
    is_software: bool,
    canvas: HtmlCanvasElement,
    surface: wgpu::Surface<'static>,
    device: wgpu::Device,
    queue: wgpu::Queue,
    config: wgpu::SurfaceConfiguration,
    pipeline: wgpu::RenderPipeline,
    camera: wgpu::Buffer,
    bindings: wgpu::BindGroup,
    instances: wgpu::Buffer,
    loss: Loss,
    lost: Promise,
    on_context_lost: Closure<dyn FnMut()>,
}

thread_local! {
    /// Whether WebGPU was tried and failed, so that a fresh canvas goes straight to WebGL 2.
    static DISTRUSTED: Cell<bool> = const { Cell::new(false) };
}

impl Backend {
    /// `webgpu` or `webgl2`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::WebGpu => "webgpu",
            Self::WebGl2 => "webgl2",
        }
    }
}

impl Gpu {
    /// Takes a fresh canvas: WebGPU if it proves to work, else WebGL 2.
    ///
    /// # Errors
    /// [`GpuError::Missing`] when there is neither.
    pub async fn attach(canvas: HtmlCanvasElement) -> Result<Self, GpuError> {
        if !DISTRUSTED.get() && proves_in_time().await {
            return Self::on(Backend::WebGpu, canvas).await;
        }
        DISTRUSTED.set(true);
        Self::on(Backend::WebGl2, canvas).await
    }

    /// Takes a fresh canvas for one backend.
    ///
    /// # Errors
    /// [`GpuError::Missing`] when the browser does not give it.
    pub async fn on(backend: Backend, canvas: HtmlCanvasElement) -> Result<Self, GpuError> {
        let missing = |error: &dyn std::error::Error| GpuError::Missing(error.to_string());
        let mut wanted = wgpu::InstanceDescriptor::new_without_display_handle();
        wanted.backends = match backend {
            Backend::WebGpu => wgpu::Backends::BROWSER_WEBGPU,
            Backend::WebGl2 => wgpu::Backends::GL,
        };
        let instance = wgpu::Instance::new(wanted);
        let target = wgpu::SurfaceTarget::Canvas(canvas.clone());
        let surface = instance.create_surface(target).map_err(|e| missing(&e))?;
        let options = wgpu::RequestAdapterOptions {
            compatible_surface: Some(&surface),
            ..Default::default()
        };
        let adapter = instance.request_adapter(&options).await.map_err(|e| missing(&e))?;
        let is_software = adapter.get_info().device_type == wgpu::DeviceType::Cpu;
        let limits = wgpu::Limits::downlevel_webgl2_defaults().using_resolution(adapter.limits());
        let wanted = wgpu::DeviceDescriptor { required_limits: limits, ..Default::default() };
        let (device, queue) = adapter.request_device(&wanted).await.map_err(|e| missing(&e))?;
        let formats = surface.get_capabilities(&adapter).formats;
        let format = formats.into_iter().find(|format| !format.is_srgb());
        let format = format.ok_or_else(|| GpuError::Missing("no plain format".to_owned()))?;
        let config = wgpu::SurfaceConfiguration {
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
            format,
            color_space: wgpu::SurfaceColorSpace::Auto,
            width: 0,
            height: 0,
            present_mode: wgpu::PresentMode::Fifo,
            desired_maximum_frame_latency: 2,
            alpha_mode: wgpu::CompositeAlphaMode::Auto,
            view_formats: Vec::new(),
        };
        let pipeline = pipeline(&device, format);
        let camera = buffer(&device, wgpu::BufferUsages::UNIFORM, 32);
        let bindings = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &pipeline.get_bind_group_layout(0),
            entries: &[wgpu::BindGroupEntry { binding: 0, resource: camera.as_entire_binding() }],
        });
        let instances = buffer(&device, wgpu::BufferUsages::VERTEX, 1 << 14);
        let (loss, receiver) = Loss::new();
        let told = loss.clone();
        device.set_device_lost_callback(move |_, reason| told.tell(reason));
        let told = loss.clone();
        device
            .on_uncaptured_error(Arc::new(move |error: wgpu::Error| told.tell(error.to_string())));
        let told = loss.clone();
        let on_context_lost: Closure<dyn FnMut()> =
            Closure::new(move || told.tell("the browser took the drawing context".to_owned()));
        let listener = on_context_lost.as_ref().unchecked_ref();
        let listening = canvas.add_event_listener_with_callback("webglcontextlost", listener);
        listening.map_err(|_| GpuError::Missing("the canvas takes no listener".to_owned()))?;
        let lost = future_to_promise(async move {
            Ok(receiver.await.map_or(JsValue::NULL, |reason| JsValue::from_str(&reason)))
        });
        Ok(Self {
            backend,
            is_software,
            canvas,
            surface,
            device,
            queue,
            config,
            pipeline,
            camera,
            bindings,
            instances,
            loss,
            lost,
            on_context_lost,
        })
    }

    /// Which backend draws.
    pub const fn backend(&self) -> Backend {
        self.backend
    }

    /// Whether there is no GPU behind it: each picture then takes the processor a good part of a second.
    pub const fn is_software(&self) -> bool {
        self.is_software
    }

    /// Resolves with a reason when the GPU takes the canvas away, with null when the picture is dropped before: nobody
    /// may be listening, and a rejection that nobody hears counts as an error in the page.
    pub fn lost(&self) -> Promise {
        self.lost.clone()
    }

    /// Draws a scene ([`Scene::floats`]) on a canvas of `width` by `height` device pixels, which becomes the
    /// canvas's size.
    ///
    /// # Errors
    /// [`GpuError::NotAScene`] for wrong numbers, [`GpuError::Lost`] when the GPU is gone.
    pub fn draw(&mut self, floats: &[f32], width: u32, height: u32) -> Result<(), GpuError> {
        self.loss.check()?;
        let wrong = || GpuError::NotAScene(floats.len());
        let (header, quads) = floats.split_first_chunk::<{ Scene::HEADER }>().ok_or_else(wrong)?;
        if quads.len() % Quad::FLOATS != 0 {
            return Err(wrong());
        }
        let [left, bottom, columns, rows, r, g, b, a] = *header;
        self.resize(width, height);
        let frame = match self.surface.get_current_texture() {
            wgpu::CurrentSurfaceTexture::Success(frame)
            | wgpu::CurrentSurfaceTexture::Suboptimal(frame) => frame,
            // Not now: the next frame will be drawn.
            wgpu::CurrentSurfaceTexture::Timeout
            | wgpu::CurrentSurfaceTexture::Occluded
            | wgpu::CurrentSurfaceTexture::Outdated => {
                self.config.width = 0;
                return Ok(());
            }
            wgpu::CurrentSurfaceTexture::Lost | wgpu::CurrentSurfaceTexture::Validation => {
                self.loss.tell("the canvas gives no frame".to_owned());
                return self.loss.check();
            }
        };
        // The cells fill the canvas as far as they can and lie in its middle, on whole pixels.
        let (w, h) = (self.config.width as f32, self.config.height as f32);
        let scale = (w / columns).min(h / rows);
        let (x, y) = (2.0 * scale / w, 2.0 * scale / h);
        let middle = |free: f32| (free / 2.0).floor();
        let offset_x = 2.0 * middle(w - scale * columns) / w - 1.0;
        let offset_y = 2.0 * middle(h - scale * rows) / h - 1.0;
        let camera = [left, bottom, x, y, offset_x, offset_y, scale, 0.0];
        self.queue.write_buffer(&self.camera, 0, bytemuck::cast_slice(&camera));
        let bytes: &[u8] = bytemuck::cast_slice(quads);
        if (bytes.len() as u64) > self.instances.size() {
            let size = (bytes.len() as u64).next_power_of_two();
            self.instances = buffer(&self.device, wgpu::BufferUsages::VERTEX, size);
        }
        self.queue.write_buffer(&self.instances, 0, bytes);
        let backdrop = wgpu::Color { r: r.into(), g: g.into(), b: b.into(), a: a.into() };
        let view = frame.texture.create_view(&wgpu::TextureViewDescriptor::default());
        let mut encoder = self.device.create_command_encoder(&Default::default());
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &view,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(backdrop),
                    store: wgpu::StoreOp::Store,
                },
            })],
            ..Default::default()
        });
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.bindings, &[]);
        pass.set_vertex_buffer(0, self.instances.slice(..));
        pass.draw(0..4, 0..(quads.len() / Quad::FLOATS) as u32);
        drop(pass);
        self.queue.submit([encoder.finish()]);
        self.queue.present(frame);
        self.loss.check()
    }

    /// Gives the canvas its size in device pixels, as far as the GPU goes.
    fn resize(&mut self, width: u32, height: u32) {
        let most = self.device.limits().max_texture_dimension_2d;
        let (width, height) = (width.clamp(1, most), height.clamp(1, most));
        if (self.config.width, self.config.height) != (width, height) {
            self.canvas.set_width(width);
            self.canvas.set_height(height);
            (self.config.width, self.config.height) = (width, height);
            self.surface.configure(&self.device, &self.config);
        }
    }
}

impl Drop for Gpu {
    fn drop(&mut self) {
        let listener = self.on_context_lost.as_ref().unchecked_ref();
        // Only a canvas that never had the listener could refuse, and it would be no matter.
        let _ = self.canvas.remove_event_listener_with_callback("webglcontextlost", listener);
    }
}

/// What a canvas shows, as rows of sRGB bytes with opacity, from the top. To be called in the task that drew:
/// a browser may clear the canvas after it was shown.
///
/// # Errors
/// What the browser throws, when the canvas has no size for one.
pub fn read_back(canvas: &HtmlCanvasElement) -> Result<Vec<u8>, JsValue> {
    let (width, height) = (canvas.width(), canvas.height());
    let copy = fresh_canvas()?;
    copy.set_width(width);
    copy.set_height(height);
    let context = copy.get_context("2d")?.ok_or(JsValue::NULL)?;
    let context: CanvasRenderingContext2d = context.dyn_into()?;
    context.draw_image_with_html_canvas_element(canvas, 0.0, 0.0)?;
    let image = context.get_image_data(0.0, 0.0, f64::from(width), f64::from(height))?;
    Ok(image.data().0)
}

/// Whether WebGPU draws what it is told, twice, with time in between for the first picture to be shown.
async fn proves() -> Result<(), GpuError> {
    let missing = |_| GpuError::Missing("no canvas".to_owned());
    let canvas = fresh_canvas().map_err(missing)?;
    let mut gpu = Gpu::on(Backend::WebGpu, canvas.clone()).await?;
    for colour in [[1.0, 0.0, 0.0, 1.0], [0.0, 0.0, 1.0, 1.0]] {
        let [r, g, b, a] = colour;
        gpu.draw(&[0.0, 0.0, 1.0, 1.0, r, g, b, a], 4, 4)?;
        let shown = read_back(&canvas).map_err(|_| GpuError::Blank)?;
        if shown.get(..4) != Some(colour.map(|c: f32| (c * 255.0) as u8).as_slice()) {
            return Err(GpuError::Blank);
        }
        // The browser needs a chance to show the picture; where it has no clock the proof fails.
        JsFuture::from(after(20)).await.map_err(|_| GpuError::Blank)?;
        gpu.loss.check()?;
    }
    Ok(())
}

/// Whether WebGPU proves itself before a person would ask where the picture is.
async fn proves_in_time() -> bool {
    let proof = future_to_promise(async {
        proves().await.map(|()| JsValue::TRUE).map_err(|error| error.to_string().into())
    });
    let verdict = Promise::race(&Array::of2(&proof, &after(3000)));
    JsFuture::from(verdict).await.is_ok_and(|verdict| verdict.is_truthy())
}

/// Resolves, with nothing, after some milliseconds. (An animation frame would not come to a hidden page.)
fn after(milliseconds: i32) -> Promise {
    Promise::new(&mut |resolve, reject| {
        let asked = web_sys::window().map(|window| {
            let wait = Window::set_timeout_with_callback_and_timeout_and_arguments_0;
            wait(&window, &resolve, milliseconds)
        });
        if !matches!(asked, Some(Ok(_))) {
            // Nobody needs to wait where there is no page.
            let _ = reject.call0(&JsValue::NULL);
        }
    })
}

fn fresh_canvas() -> Result<HtmlCanvasElement, JsValue> {
    let document = web_sys::window().and_then(|w| w.document()).ok_or(JsValue::NULL)?;
    Ok(document.create_element("canvas")?.dyn_into()?)
}

fn buffer(device: &wgpu::Device, usage: wgpu::BufferUsages, size: u64) -> wgpu::Buffer {
    device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size,
        usage: usage | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    })
}

/// One instanced strip of four corners; blending is of premultiplied colours.
fn pipeline(device: &wgpu::Device, format: wgpu::TextureFormat) -> wgpu::RenderPipeline {
    let shader = device.create_shader_module(wgpu::include_wgsl!("scene.wgsl"));
    let attributes = wgpu::vertex_attr_array![
        0 => Float32x4, 1 => Float32x4, 2 => Float32x4, 3 => Float32x4
    ];
    let instance = wgpu::VertexBufferLayout {
        array_stride: (Quad::FLOATS * size_of::<f32>()) as u64,
        step_mode: wgpu::VertexStepMode::Instance,
        attributes: &attributes,
    };
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: None,
        layout: None,
        vertex: wgpu::VertexState {
            module: &shader,
            entry_point: Some("vertex"),
            compilation_options: Default::default(),
            buffers: &[Some(instance)],
        },
        primitive: wgpu::PrimitiveState {
            topology: wgpu::PrimitiveTopology::TriangleStrip,
            ..Default::default()
        },
        depth_stencil: None,
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(wgpu::FragmentState {
            module: &shader,
            entry_point: Some("fragment"),
            compilation_options: Default::default(),
            targets: &[Some(wgpu::ColorTargetState {
                format,
                blend: Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
                write_mask: wgpu::ColorWrites::ALL,
            })],
        }),
        multiview_mask: None,
        cache: None,
    })
}

/// Whether the GPU still draws; the first reason why not is told once to whoever waits for it.
#[derive(Clone)]
struct Loss(Arc<Mutex<Health>>);

enum Health {
    Well(oneshot::Sender<String>),
    Lost(String),
}

impl Loss {
    fn new() -> (Self, oneshot::Receiver<String>) {
        let (sender, receiver) = oneshot::channel();
        (Self(Arc::new(Mutex::new(Health::Well(sender)))), receiver)
    }

    fn tell(&self, reason: String) {
        let mut health = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if matches!(*health, Health::Well(_))
            && let Health::Well(sender) = replace(&mut *health, Health::Lost(reason.clone()))
        {
            DISTRUSTED.set(true);
            // Nobody may be waiting any more.
            let _ = sender.send(reason);
        }
    }

    fn check(&self) -> Result<(), GpuError> {
        match &*self.0.lock().unwrap_or_else(PoisonError::into_inner) {
            Health::Well(_) => Ok(()),
            Health::Lost(reason) => Err(GpuError::Lost(reason.clone())),
        }
    }
}
