using System;

namespace Nowpose.Session
{
    /// <summary>A flag that becomes true after its input has been true for some time, and false as soon as its input is false.</summary>
    struct SettledFlag
    {
        bool _isRising;
        HeadsetTime _since;

        /// <param name="value">Initial value, which is not reported as a change; null without an initial value.</param>
        public SettledFlag(bool? value)
        {
            Value = value;
            _isRising = false;
            _since = default;
        }

        /// <summary>The last reported value.</summary>
        public bool? Value { get; private set; }

        /// <returns>Whether <see cref="Value"/> has changed.</returns>
        public bool Update(HeadsetTime at, bool isTrue, TimeSpan settle)
        {
            if (isTrue && !_isRising) _since = at;
            _isRising = isTrue;
            if (Value == isTrue || (isTrue && at - _since < settle)) return false;
            Value = isTrue;
            return true;
        }

        /// <summary>Keeps the value but restarts the waiting time, because the input is unknown.</summary>
        public void Interrupt() => _isRising = false;
    }
}
