using System;

namespace Nowpose.Session
{
    /// <summary>Good news that may flicker: it counts once it has been true for a while, and ends at once.</summary>
    struct SettledFlag
    {
        bool _isRising;
        HeadsetTime _since;

        /// <param name="value">What counts as said already; null for nothing.</param>
        public SettledFlag(bool? value)
        {
            Value = value;
            _isRising = false;
            _since = default;
        }

        /// <summary>What was last said.</summary>
        public bool? Value { get; private set; }

        /// <returns>Whether there is news in <see cref="Value"/>.</returns>
        public bool Update(HeadsetTime at, bool isTrue, TimeSpan settle)
        {
            if (isTrue && !_isRising) _since = at;
            _isRising = isTrue;
            if (Value == isTrue || (isTrue && at - _since < settle)) return false;
            Value = isTrue;
            return true;
        }

        /// <summary>Neither true nor false: what was said stays, but the while begins anew.</summary>
        public void Interrupt() => _isRising = false;
    }
}
