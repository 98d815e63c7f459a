using Nowpose.Latency;
using Nowpose.Unity.Status;
using UnityEngine;

namespace Nowpose.Unity.Calibration
{
    /// <summary>The objects of a timestamp display: the code, the time as text below it, and a message while the time is unknown.</summary>
    sealed class TimestampSheet
    {
        const string Name = "Timestamp";

        /// <summary>Font height as a share of the code's side, and the gap below the code: one of its cells.</summary>
        const float Height = 0.25f, Gap = 1f / TimestampCode.Side;

        readonly GameObject _object;
        readonly TimestampMesh _code;
        readonly MeshRenderer _renderer;
        readonly TimestampDigits _digits;
        PanelCell _words;
        int _shown = -1;

        /// <param name="model">A text to copy; null for none.</param>
        /// <param name="light">Material of the lit squares.</param>
        /// <param name="side">Side of the code, in metres.</param>
        public TimestampSheet(Transform parent, TextMesh model, Material light, float side)
        {
            RemoveFrom(parent);
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

        /// <summary>Shows a time. Allocates nothing.</summary>
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

        /// <summary>Hides code and time, and shows a message.</summary>
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
            Object.Destroy(_object);
        }

        // Rounds down as in the code, also before the epoch.
        static int WholeMs(ControlTime time)
        {
            var ticks = time.SinceEpoch.Ticks % (TimestampDigits.PeriodMs * System.TimeSpan.TicksPerMillisecond);
            if (ticks < 0) ticks += TimestampDigits.PeriodMs * System.TimeSpan.TicksPerMillisecond;
            return (int)(ticks / System.TimeSpan.TicksPerMillisecond);
        }

        // When scripts are recompiled in play mode, the objects remain but the references are lost.
        static void RemoveFrom(Transform parent)
        {
            var left = parent.Find(Name);
            if (left == null) return;
            left.SetParent(null, worldPositionStays: false);
            Object.Destroy(left.gameObject);
        }
    }
}
