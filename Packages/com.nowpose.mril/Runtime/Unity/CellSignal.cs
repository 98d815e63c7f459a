using System;
using System.Globalization;
using Nowpose.Signals;
using Nowpose.Unity.Cell;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Rendering;
using Nowpose.Unity.Session;
using UnityEngine;
using UnityEngine.Events;

namespace Nowpose.Unity
{
    /// <summary>
    /// Raises events when a signal of the control system changes, in the frame whose display time reaches the time of the change.
    /// </summary>
    /// <remarks>
    /// A Boolean has the value 0 or 1. The events report the first known value and then each change exactly once, in order, even if several changes
    /// become visible in the same frame. Assign any method with one parameter, such as <c>GameObject.SetActive</c>, <c>Animator.SetTrigger</c> or
    /// <c>TextMesh.text</c>. Methods that take the name of a parameter and its value, such as <c>Animator.SetBool</c> and <c>Animator.SetFloat</c>,
    /// have events of their own. While the value is not current or the component is disabled, the <see cref="PoseAppearance"/> on this object or above
    /// it stripes the objects at and below this object; use the last two events for objects elsewhere. An event must not switch off this object or a
    /// parent, because the component then raises no more events.
    /// </remarks>
    [AddComponentMenu("Nowpose/Signal")]
    public sealed class CellSignal : MonoBehaviour, ISignalComponent, IFollowsSession
    {
        [SerializeField, Tooltip("The session that receives the signal. Empty: the session on this object or a parent.")]
        MrilSession _session = null;

        [SerializeField, Tooltip("Name of the signal on /signals. Empty: the name of this object.")]
        string _signal = "";

        [SerializeField, Tooltip("Raised when the value becomes 0.5 or more: a Boolean becomes true.")]
        UnityEvent _onTrue = new UnityEvent();

        [SerializeField, Tooltip("Raised when the value becomes less than 0.5: a Boolean becomes false.")]
        UnityEvent _onFalse = new UnityEvent();

        [SerializeField, Tooltip("Raised with true or false when a Boolean changes.")]
        UnityEvent<bool> _onState = new UnityEvent<bool>();

        [SerializeField, Tooltip("Raised with each new value.")]
        UnityEvent<float> _onValue = new UnityEvent<float>();

        [SerializeField, Tooltip("Raised with each new value as a string.")]
        UnityEvent<string> _onText = new UnityEvent<string>();

        [SerializeField, Tooltip("Number format of On Text, as in .NET: 0.0 with one decimal, 0.0 mm with a unit, on;;off for a Boolean.")]
        string _textFormat = "0.###";

        [SerializeField, Tooltip("Name that the following events pass with the value, such as the name of an Animator's parameter. Empty: the name "
            + "of the signal.")]
        string _parameter = "";

        [SerializeField, Tooltip("Raised with Parameter and true or false when a Boolean changes, for example for Animator.SetBool.")]
        UnityEvent<string, bool> _onNamedState = new UnityEvent<string, bool>();

        [SerializeField, Tooltip("Raised with Parameter and each new value, for example for Animator.SetFloat.")]
        UnityEvent<string, float> _onNamedValue = new UnityEvent<string, float>();

        [SerializeField, Tooltip("Raised with Parameter and each new value rounded to an integer, for example for Animator.SetInteger.")]
        UnityEvent<string, int> _onNamedInteger = new UnityEvent<string, int>();

        [SerializeField, Tooltip("Raised with the reason when the value is no longer current, for example because its source has ended, and when the "
            + "reason changes. Also raised at the start, until the first value arrives.")]
        UnityEvent<string> _onNotCurrent = new UnityEvent<string>();

        [SerializeField, Tooltip("Raised when the value becomes current, after the events for the value.")]
        UnityEvent _onCurrent = new UnityEvent();

        readonly Listeners<Action<double>> _changed = new Listeners<Action<double>>();
        readonly AppearancesOfParts _appearances = new AppearancesOfParts();
        SignalFollower _follower;
        bool? _isOn;
        bool _isMissingReported;
        [NonSerialized] string _disabled;

        /// <summary>Name of the signal.</summary>
        public string Signal => _follower != null ? _follower.Name : string.IsNullOrEmpty(_signal) ? name : _signal;

        /// <summary>The value at the display time; null while no value is known.</summary>
        public double? Value => _follower?.Track?.Value;

        /// <summary>Control time since which the signal has had its value; null while this time is unknown.</summary>
        public ControlTime? Since => _follower?.Track?.Since;

        /// <summary>Reason why the value is not current, in one line; null if it is current.</summary>
        public string Fault => _follower != null ? _follower.Fault : isActiveAndEnabled ? StatusMessages.NoSession
            : (_disabled ??= ObjectMessages.Disabled("signal", name));

        /// <summary>The events of the Inspector.</summary>
        internal UnityEventBase[] Events => new UnityEventBase[]
        {
            _onTrue, _onFalse, _onState, _onValue, _onText, _onNamedState, _onNamedValue, _onNamedInteger, _onNotCurrent, _onCurrent,
        };

        /// <summary>The signal's follower; null while the component follows no signal.</summary>
        internal SignalFollower Follower => _follower;

        string ISignalComponent.FaultLabel => ObjectMessages.SignalNotCurrent;

        MrilSession IFollowsSession.AssignedSession => _session;

        /// <summary>Raised with each new value.</summary>
        public event Action<double> Changed { add => _changed.Add(value); remove => _changed.Remove(value); }

        /// <summary>
        /// Sets the fields Session and Signal, and follows the signal from now on. A script can call this method at any time, for example after it has
        /// created the object.
        /// </summary>
        /// <param name="session">The session that receives the signal; null to use the session on this object or a parent.</param>
        /// <param name="signal">Name of the signal; empty for the name of this object.</param>
        public void Follow(MrilSession session, string signal = "")
        {
            var isFollowing = isActiveAndEnabled;
            if (isFollowing) Leave();
            _session = session;
            _signal = signal;
            if (isFollowing) OnEnable();
            if (TryGetComponent<PoseAppearance>(out var appearance)) appearance.FindSession();
        }

        void OnEnable()
        {
            (_isOn, _isMissingReported) = (null, false);
            _follower = SignalFollower.Of(this, _session, "signal", Signal, Take, judged: Judge);
            _appearances.RefreshIfMoved(this);
            _disabled = null;
        }

        // Before the session computes its first frame, the value is not current. In OnEnable, other objects may not be ready for the event yet.
        void Start() => _follower?.Update(null);

        // The session may have ended. While its component is being disabled, no event is raised, because a listener must not switch objects then.
        void LateUpdate()
        {
            if (_follower == null) ReportMissing();
            else if (_follower.Source.Session == null) _follower.Judge();
        }

        void OnDisable()
        {
            if (_follower != null && _follower.IsRaising) ConsoleLog.Warn(this, ComponentMessages.Of("signal", name, ObjectMessages.DisabledByItself));
            Leave();
        }

        void Leave()
        {
            _follower?.Leave();
            _follower = null;
        }

        void Judge(string fault)
        {
            if (fault == null) _onCurrent.Raise(this);
            else _onNotCurrent.Raise(this, fault);
        }

        // Without a session component, no follower reports the reason.
        void ReportMissing()
        {
            if (_isMissingReported) return;
            _isMissingReported = true;
            Judge(Fault);
        }

        void OnTransformParentChanged()
        {
            _appearances.Refresh(this);
            if (!this.IsBelowAnotherSession(_session, _follower?.Source)) return;
            Leave();
            OnEnable();
        }

        void Take(SignalTrack signal)
        {
            var value = signal.Value;
            var isOn = SignalTrack.IsOn(value);
            if (isOn != _isOn)
            {
                _isOn = isOn;
                (isOn ? _onTrue : _onFalse).Raise(this);
                _onState.Raise(this, isOn);
                _onNamedState.Raise(this, Parameter, isOn);
            }
            _onValue.Raise(this, (float)value);
            _onNamedValue.Raise(this, Parameter, (float)value);
            _onNamedInteger.Raise(this, Parameter, ToInteger(value));
            // Formats the text only if there are listeners, because formatting allocates.
            if (_onText.GetPersistentEventCount() > 0) _onText.Raise(this, Text(value));
            _changed.Raise(this, value);
        }

        string Parameter => string.IsNullOrEmpty(_parameter) ? Signal : _parameter;

        // A value beyond the range of an integer becomes the nearest integer.
        static int ToInteger(double value) => (int)Math.Round(Math.Min(Math.Max(value, int.MinValue), int.MaxValue));

        string Text(double value)
        {
            try
            {
                return value.ToString(_textFormat, CultureInfo.InvariantCulture);
            }
            catch (FormatException)
            {
                return value.ToString(CultureInfo.InvariantCulture);
            }
        }
    }
}
