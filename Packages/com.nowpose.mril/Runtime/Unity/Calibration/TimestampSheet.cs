using Nowpose.Latency;
using Nowpose.Unity.Status;
using UnityEngine;

namespace Nowpose.Unity.Calibration
{
    /// <summary>
    /// Creates the objects of a timestamp display: the code and, below it, the time as text or, while the time is unknown, a message.
    /// </summary>
    sealed class TimestampSheet
    {
        const string Name = "Timestamp";

        /// <summary>
        /// Height: height of the font. Gap: gap between code and text, as wide as one cell of the code. Both are fractions of the code's side length.
        /// </summary>
        const float Height = 0.25f, Gap = 1f / TimestampCode.Side;

        readonly GameObject _object;
        readonly TimestampMesh _code;
        readonly MeshRenderer _renderer;
        readonly TimestampDigits _digits;
        PanelCell _words;
        int _shown = -1;

        /// <param name="model">Text object to copy for the digits and the message; null for a code without text.</param>
        /// <param name="light">Material of the lit squares.</param>
        /// <param name="side">Side length of the code, in metres.</param>
        public TimestampSheet(Transform parent, TextMesh model, Material light, float side)
        {
            RemoveFrom(parent, model);
            _object = new GameObject(Name) { layer = parent.gameObject.layer };
            _object.transform.SetParent(parent, worldPositionStays: false);
            _code = new TimestampMesh(side);
            _object.AddComponent<MeshFilter>().sharedMesh = _code.Mesh;
            _renderer = _object.AddComponent<MeshRenderer>();
            _renderer.sharedMaterial = light;
            _renderer.enabled = false;
            if (model == null) return;
            model.gameObject.SetActive(false);
            var below = Vector3.down * ((0.5f + Gap + Height / 2) * side);
            _digits = new TimestampDigits(_object.transform, model, below, Height * side);
            _words = TimestampDigits.Copy("Words", _object.transform, model, below, Height * side);
        }

        /// <summary>Whether the objects were destroyed.</summary>
        public bool IsDestroyed => _object == null;

        /// <summary>Shows a time as code and as text. Does not allocate.</summary>
        public void Show(ControlTime time)
        {
            _words.Show("");
            _renderer.enabled = true;
            var ms = WholeMs(time);
            if (ms == _shown) return;
            _shown = ms;
            _code.Show(TimestampCode.ValueOf(time));
            _digits?.Show(ms);
        }

        /// <summary>Hides the code and the time, and shows a message instead.</summary>
        public void Blank(string words)
        {
            _renderer.enabled = false;
            _digits?.Clear();
            _shown = -1;
            _words.Show(words);
        }

        public void Destroy()
        {
            Object.Destroy(_code.Mesh);
            if (!IsDestroyed) Object.Destroy(_object);
        }

        // Rounds down like TimestampCode.ValueOf, including for times before the epoch.
        static int WholeMs(ControlTime time)
        {
            var ticks = time.SinceEpoch.Ticks % (TimestampDigits.PeriodMs * System.TimeSpan.TicksPerMillisecond);
            if (ticks < 0) ticks += TimestampDigits.PeriodMs * System.TimeSpan.TicksPerMillisecond;
            return (int)(ticks / System.TimeSpan.TicksPerMillisecond);
        }

        // Removes the objects of an earlier instance. When Unity recompiles scripts in play mode, the objects remain but the references to them are
        // lost.
        static void RemoveFrom(Transform parent, TextMesh model)
        {
            var left = parent.Find(Name);
            if (left == null || (model != null && model.transform.IsChildOf(left))) return;
            left.SetParent(null, worldPositionStays: false);
            Object.Destroy(left.gameObject);
        }
    }
}
