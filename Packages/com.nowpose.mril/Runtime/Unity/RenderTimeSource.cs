using System;
using System.Collections;
using Nowpose.Latency;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Rendering;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>
    /// Measures the duration of each frame's render job with the best available source, and reports it to the session. Poses are not current
    /// while this duration is outside the constant-latency range.
    /// </summary>
    /// <remarks>
    /// The sources, best first: the GPU time from the headset's runtime; the GPU time from Unity (needs Frame Timing Stats in the player
    /// settings); the time from the trigger to the GPU's completion, measured by a readback; the CPU time of the cameras (built-in render
    /// pipeline only), which does not include the GPU. A limit that was measured with one source is not valid for another source.
    /// </remarks>
    [AddComponentMenu("Nowpose/Render Time Source")]
    [DisallowMultipleComponent]
    public sealed class RenderTimeSource : MonoBehaviour
    {
        const int Display = 0, Engine = 1, Completion = 2, Cameras = 3;

        [SerializeField, Tooltip("The session that receives the render times. Empty: the session on this object or a parent.")]
        MrilSession _session = null;

        readonly GpuTimes _gpu = new GpuTimes();
        readonly WaitForEndOfFrame _endOfFrame = new WaitForEndOfFrame();
        RenderTimeChoice _choice;
        MrilSession _target;
        IHeadsetClock _clock;
        GpuCompletion _completion;
        Coroutine _watch;
        CameraTime _cameras;
        HeadsetTime? _trigger;

        /// <summary>
        /// Source of the render times; <see cref="RenderTimeSourceKind.None"/> in the first 30 measured frames and if no source works.
        /// </summary>
        public RenderTimeSourceKind Source => _choice?.Source ?? RenderTimeSourceKind.None;

        /// <summary>The newest Δt_render; null if no new measurement has become available in this frame.</summary>
        public TimeSpan? RenderTime => _choice?.RenderTime;

        void OnEnable()
        {
            _target = this.RequiredSession(_session, "render time source");
            _clock = _target.ClockOrDevices();
            _choice = new RenderTimeChoice(
                RenderTimeSourceKind.DisplayGpuTime, RenderTimeSourceKind.EngineGpuTime, RenderTimeSourceKind.GpuCompletion, RenderTimeSourceKind.CameraCpu);
            _completion = new GpuCompletion(_clock);
            _cameras = default;
            _trigger = null;
            Application.onBeforeRender += Trigger;
            Camera.onPreRender += Begin;
            Camera.onPostRender += End;
            _watch = StartCoroutine(WatchSubmissions());
        }

        void OnDisable()
        {
            Application.onBeforeRender -= Trigger;
            Camera.onPreRender -= Begin;
            Camera.onPostRender -= End;
            StopCoroutine(_watch);
            _completion.Release();
            _choice = null;
            Notify();
        }

        void LateUpdate()
        {
            _choice.Report(Display, _gpu.OfDisplay());
            _choice.Report(Engine, _gpu.OfEngine());
            _choice.Report(Completion, _completion.Take());
            _choice.Report(Cameras, _cameras.Take());
            if (_choice.EndFrame()) LogSource();
            Notify();
        }

        // Runs after all other handlers of this event, so this is the time at which rendering starts.
        [BeforeRenderOrder(int.MaxValue)]
        void Trigger() => _trigger = _clock.Now;

        void Begin(Camera camera)
        {
            if (IsGameCamera(camera)) _cameras.Begin(_clock.Now);
        }

        void End(Camera camera)
        {
            if (IsGameCamera(camera)) _cameras.End(_clock.Now);
        }

        // Excludes the cameras of the editor's scene views and previews, which render in the same frames.
        static bool IsGameCamera(Camera camera) => (camera.hideFlags & HideFlags.DontSave) == 0;

        IEnumerator WatchSubmissions()
        {
            while (true)
            {
                yield return _endOfFrame;
                // If the GPU time of this frame is known, a readback is not necessary.
                var isGpuTime = Source == RenderTimeSourceKind.DisplayGpuTime || Source == RenderTimeSourceKind.EngineGpuTime;
                var isNeeded = !isGpuTime || RenderTime == null;
                if (isNeeded && _trigger is HeadsetTime triggered) _completion.Submitted(triggered);
                _trigger = null;
            }
        }

        void Notify()
        {
            if (_target == null || _target.Session == null) return;
            if (Source == RenderTimeSourceKind.None) _target.Session.Rendered(TimeSpan.Zero, RenderTimeSourceKind.None);
            else if (RenderTime is TimeSpan renderTime) _target.Session.Rendered(renderTime, Source);
        }

        void LogSource()
        {
            var message = "render time: " + RenderTimeNames.NameOf(Source);
            if (Source == RenderTimeSourceKind.None || Source == RenderTimeSourceKind.CameraCpu) ConsoleLog.Warn(this, message);
            else ConsoleLog.Info(this, message);
        }
    }
}
