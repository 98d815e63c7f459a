using Nowpose.Session;
using Nowpose.Signals;
using Nowpose.Unity.Cell;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>Moves this object between two places by a signal, such as the jaw of a gripper, a cylinder or a door.</summary>
    /// <remarks>
    /// The move starts at the stamp of the change and takes the stroke time, so it is in phase with the real part although the message was late
    /// (<see cref="ActuatedStroke"/>). The place at 0 is that of the object when it is enabled, in its parent's axes. While no value is known, the
    /// object stays there.
    /// </remarks>
    [AddComponentMenu("Nowpose/Actuated Part")]
    [DisallowMultipleComponent]
    public sealed class ActuatedPart : MonoBehaviour
    {
        [SerializeField, Tooltip("The session that receives the signal. Empty: the session on this object or a parent.")]
        MrilSession _session = null;

        [SerializeField, Tooltip("Name of the signal on /signals. Empty: the name of this object.")]
        string _signal = "";

        [SerializeField, Tooltip("Displacement from the place at 0 to the place at 1, in the parent's axes, metres.")]
        Vector3 _wayMetres = Vector3.zero;

        [SerializeField, Tooltip("Rotation from 0 to 1 about the object's own axes, Euler angles in degrees.")]
        Vector3 _turnDegrees = Vector3.zero;

        [SerializeField, Range(0, 60_000), Tooltip("Time for the whole stroke, ms. 0: the part jumps.")]
        float _strokeMs = 300;

        MrilSession _source;
        SignalFollower _follower;
        ActuatedStroke _stroke;
        Vector3 _restPosition;
        Quaternion _restRotation;

        /// <summary>Name of the signal.</summary>
        public string Signal => string.IsNullOrEmpty(_signal) ? name : _signal;

        /// <summary>Share of the stroke in the newest frame, 0 to 1.</summary>
        public float Share { get; private set; }

        /// <summary>Why the signal's value is not current, in one line; null if it is.</summary>
        public string Fault => _follower == null ? "no session" : _follower.Fault;

        void OnEnable()
        {
            _restPosition = transform.localPosition;
            _restRotation = transform.localRotation;
            _stroke = new ActuatedStroke(0, 1, _strokeMs / 1000.0);
            _follower = SignalFollower.Of(this, _session, "actuated part", Signal, Take, restarted: Take);
            _source = this.SessionOr(_session);
            if (_source != null) _source.Shown += Show;
        }

        void OnDisable()
        {
            _follower?.Leave();
            _follower = null;
            if (_source is object) _source.Shown -= Show;
            _source = null;
            Move(0);
        }

        void Show(DisplayFrame frame)
        {
            if (frame.DisplayTime is ControlTime light) Move((float)_stroke.At(light));
        }

        // After a step of the clock the time of the value is unknown, so the part is where the value puts it.
        void Take(SignalTrack signal)
        {
            if (!signal.Since.HasValue) _stroke.Forget(null);
            _stroke.Change(signal.Value, signal.Since ?? default);
        }

        void Move(float share)
        {
            Share = share;
            transform.localPosition = _restPosition + share * _wayMetres;
            transform.localRotation = _restRotation * Quaternion.Euler(share * _turnDegrees);
        }
    }
}
