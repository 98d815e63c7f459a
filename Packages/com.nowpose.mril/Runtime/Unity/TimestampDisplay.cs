using Nowpose.Session;
using Nowpose.Unity.Calibration;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>
    /// Shows the start time of each frame in control time, as a code for a camera and as text. The visualisation latency is computed from a picture
    /// that shows this code beside the code on a display of the control system.
    /// </summary>
    /// <remarks>
    /// Implements Fig. 9 and Eq. (7) of Schnierle &amp; Röck 2022: the shown time is C2(t_MR), converted to C1. It always belongs to the frame in
    /// which it is drawn, because it is updated in the event <see cref="MrilSession.Shown"/>, which is raised again when a frame is recomputed
    /// right before rendering.
    /// </remarks>
    [AddComponentMenu("Nowpose/Timestamp Display")]
    [DefaultExecutionOrder(MrilSession.ExecutionOrder + 2)]
    [DisallowMultipleComponent]
    public sealed class TimestampDisplay : MonoBehaviour
    {
        [SerializeField, Tooltip("The session whose frames are shown. Empty: the session on this object or a parent.")]
        MrilSession _session = null;

        [SerializeField, Tooltip("A Text Mesh below this object. The time copies its font, material and colour. Keep it inactive. Empty: only the "
            + "code is shown.")]
        TextMesh _cell = null;

        [SerializeField, Tooltip("Material of the code's lit squares. Choose a bright, unlit one. Dark squares are not drawn.")]
        Material _light = null;

        [SerializeField, Range(0.02f, 1), Tooltip("Side length of the code in metres. Default 0.1: an eighth of the picture's height in a "
            + "headset camera at 1 m; a tenth is enough to read it.")]
        float _sideMetres = 0.1f;

        MrilSession _source;
        TimestampSheet _sheet;

        /// <summary>The displayed time: the start of the frame in control time. Null while no time is displayed.</summary>
        public ControlTime? FrameStart { get; private set; }

        void OnEnable()
        {
            _source = this.RequiredSession(_session, "timestamp display");
            if (_light == null) ConsoleLog.Fail(this, ComponentMessages.DisplayWithoutMaterial(name));
            if (_source == null) return;
            _source.Shown += Show;
            _source.Hidden += Hide;
        }

        void OnDisable()
        {
            if (_source != null)
            {
                _source.Shown -= Show;
                _source.Hidden -= Hide;
            }
            FrameStart = null;
            _sheet?.Destroy();
            _sheet = null;
        }

        // Shows a message until the first frame. OnEnable cannot show it, because Unity does not allow new children while it enables objects.
        void LateUpdate()
        {
            if (_sheet == null || _sheet.IsDestroyed) Hide();
        }

        void Show(DisplayFrame frame)
        {
            FrameStart = FrameControlTime.Of(_source, frame);
            if (FrameStart is ControlTime start) Sheet.Show(start);
            else Sheet.Blank(StatusMessages.ClockNotSynchronised);
        }

        void Hide()
        {
            FrameStart = null;
            Sheet.Blank(StatusMessages.NoSession);
        }

        TimestampSheet Sheet
        {
            get
            {
                if (_sheet != null && !_sheet.IsDestroyed) return _sheet;
                _sheet?.Destroy();
                return _sheet = new TimestampSheet(transform, _cell, _light, _sideMetres);
            }
        }
    }
}
