using System;
using Nowpose.Prediction.Samples;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Signals
{
    /// <summary>Keeps the changes of one signal in control time; the newest change at or before the display time is visible.</summary>
    sealed class SignalTrack
    {
        /// <summary>
        /// Maximum number of changes kept, including the visible one: more than a second of a signal that changes 60 times per second.
        /// </summary>
        const int Capacity = 64;

        /// <summary>Stamp that replaces an invalid stamp. It is earlier than all received stamps, which are positive.</summary>
        static ControlTime Always => default;

        // Changes in the order of their stamps, oldest first. The first change is the visible change if _isVisible is true.
        readonly Change[] _changes = new Change[Capacity];
        readonly LateValues _late = new LateValues();
        // Newest time for which an ordinary value is known or may still arrive: the newest stamp, without announced changes.
        ControlTime? _newestSample;
        // Newest received value, if its stamp was in the future.
        double? _future;
        int _count;
        bool _isVisible;
        // Whether no value has been used since an interruption.
        bool _isInterrupted;

        public SignalTrack(string name) => Name = name;

        public string Name { get; }

        /// <summary>Raised when all times have become invalid. <see cref="Value"/> is kept, and <see cref="Since"/> becomes null.</summary>
        public event Action<SignalTrack> Restarted;

        /// <summary>
        /// Raised when the first value after an interruption, or after dropped changes from or to <see cref="IsOn"/>, becomes visible, before it is
        /// reported as a change. The signal may have changed in the meantime, also if the value is the same as before. Not raised if the value has
        /// the stamp <see cref="Newest"/>, which shows that nothing has changed.
        /// </summary>
        public event Action<SignalTrack> Resumed;

        /// <summary>Raised when a change is dropped before it was visible, because too many newer changes wait.</summary>
        public event Action<SignalTrack> Overflowed;

        /// <summary>Whether a value is visible.</summary>
        public bool IsKnown => _isVisible;

        /// <summary>The visible value; 0 while no value is visible.</summary>
        public double Value => _isVisible ? _changes[0].Value : 0;

        /// <summary>
        /// Control time since which the signal has had the visible value; null while no value is visible, and after <see cref="Restart"/> until the
        /// next change.
        /// </summary>
        public ControlTime? Since => _isVisible && _changes[0].Stamp > Always ? _changes[0].Stamp : (ControlTime?)null;

        /// <summary>Returns whether a value counts as true, or as a closed gripper.</summary>
        public static bool IsOn(double value) => value >= 0.5;

        /// <summary>Stamp of the newest message, with or without a change; null before the first.</summary>
        public ControlTime? Newest { get; private set; }

        /// <summary>Headset time at which the last value arrived that was used or is <see cref="Unplaced"/>; null if unknown.</summary>
        public HeadsetTime? Received { get; set; }

        /// <summary>
        /// The newest received value, if its stamp does not match the control time: it is in the future, or too late to have been overtaken on the
        /// network. Otherwise null.
        /// </summary>
        /// <remarks>Either the control clock has stepped, which the headset does not know yet, or the clock of the source is wrong.</remarks>
        public double? Unplaced => _future ?? _late.NewestFarBehind(_newestSample);

        /// <summary>
        /// Handles an interruption: the source may have ended since its last value, or changes were dropped. The next value that is used is not an
        /// overtaken one, and raises <see cref="Resumed"/>.
        /// </summary>
        public void Interrupt() => _isInterrupted = _count > 0;

        /// <summary>Adds a received value, which may repeat the previous value.</summary>
        /// <remarks>
        /// If late stamps show that the source's clock went back, the signal restarts with the late values. An announced change, whose stamp is later
        /// than its arrival, does not make the values after it late. A value that is too late to have been overtaken comes from another source, or its
        /// source has restarted; it is sufficient if it differs from the known values, because a source that publishes only changes sends no other.
        /// </remarks>
        /// <param name="arrival">Control time of the arrival; null if unknown.</param>
        public DropReason Add(ControlTime stamp, double value, ControlTime? arrival = null)
        {
            _future = null;
            var newest = _isInterrupted ? Newest : _newestSample;
            if (stamp < newest && (_isInterrupted || !LateValues.IsOvertaken(stamp, newest)) && !Includes(stamp, value))
            {
                RestartWith(stackalloc[] { (stamp, value) });
                return DropReason.None;
            }
            if (stamp > arrival)
            {
                // The ordinary values that follow may be late by a normal delay. If they are older, the clock of the source went back.
                if (!(arrival.Value - ClockTicks.Span(ArrivalLimits.MaxDelay) <= _newestSample)) _newestSample = arrival.Value - ClockTicks.Span(ArrivalLimits.MaxDelay);
                return Place(stamp, value);
            }
            if (_late.Add(stamp, value, _newestSample))
            {
                RestartWith(_late.All);
                return DropReason.None;
            }
            if (!(stamp <= _newestSample)) _newestSample = stamp;
            return Place(stamp, value);
        }

        /// <summary>Keeps a received value whose stamp is in the future until the next value or the next <see cref="Restart"/>.</summary>
        public void AddFuture(double value) => _future = value;

        /// <summary>Makes the next change visible if the display time has reached it.</summary>
        /// <returns>Whether a change has become visible. Call the method until it returns false, so that no change is missed.</returns>
        public bool Next(ControlTime at)
        {
            while (_isVisible && _count > 1 && _changes[1].Stamp <= at && _changes[1].Value == Value)
            {
                var isResumed = _changes[1].IsResumed;
                _changes[0].Confirm(_changes[1].Confirmed);
                Remove(1);
                if (isResumed) Resumed?.Invoke(this);
            }
            var next = _isVisible ? 1 : 0;
            if (next >= _count || _changes[next].Stamp > at) return false;
            if (_isVisible) Remove(0);
            _isVisible = true;
            if (_changes[0].IsResumed) Resumed?.Invoke(this);
            return true;
        }

        /// <summary>
        /// Discards all times, because they are no longer valid. The newest value, also an <see cref="Unplaced"/> one, becomes visible, because a
        /// source that publishes only changes does not repeat it.
        /// </summary>
        public void Restart()
        {
            if (_count == 0 && Unplaced == null) return;
            var unplaced = Unplaced;
            var newest = unplaced ?? _changes[_count - 1].Value;
            var isResumed = DiscardTimes() || (_isInterrupted && unplaced.HasValue);
            if (isResumed || !_isVisible || Value != newest) _changes[_count++] = new Change(Always, newest, isResumed);
            if (unplaced.HasValue) _isInterrupted = false;
            _future = null;
            _late.Clear();
            Restarted?.Invoke(this);
        }

        /// <summary>Reports the visible value and the changes that are not visible yet, except one whose time is no longer valid.</summary>
        public void Report(Action<SignalValue, ControlTime> report)
        {
            for (var i = 0; i < _count; i++)
                if (_changes[i].Stamp > Always) report(new SignalValue(Name, _changes[i].Value), _changes[i].Stamp);
        }

        // Keeps the visible value until the display time reaches the first late value. Discards the other values, because their stamps are from
        // before the clock went back.
        void RestartWith(ReadOnlySpan<(ControlTime, double)> lateValues)
        {
            _isInterrupted |= DiscardTimes();
            foreach (var (stamp, value) in lateValues) Place(stamp, value);
            _late.Clear();
            Restarted?.Invoke(this);
        }

        // Keeps only the visible value. Returns whether a discarded value was the first after an interruption.
        bool DiscardTimes()
        {
            var isResumed = false;
            for (var i = _isVisible ? 1 : 0; i < _count; i++) isResumed |= _changes[i].IsResumed;
            _count = 0;
            if (_isVisible) _changes[_count++] = new Change(Always, _changes[0].Value);
            Newest = _newestSample = null;
            return isResumed;
        }

        // Returns whether the signal had a value at a time, according to the changes that are kept.
        bool Includes(ControlTime stamp, double value)
        {
            var place = _count - 1;
            while (place >= 0 && _changes[place].Stamp > stamp) place--;
            return place >= 0 && _changes[place].Value == value;
        }

        DropReason Place(ControlTime stamp, double value)
        {
            var isResumed = _isInterrupted && stamp != Newest;
            var place = _count;
            while (place > 0 && _changes[place - 1].Stamp > stamp) place--;
            if (_isVisible && place == 0) return DropReason.LateSample;
            _isInterrupted = false;
            if (place > 0 && _changes[place - 1].Stamp == stamp) return Replace(place - 1, value);
            if (!(stamp <= Newest)) Newest = stamp;
            if (isResumed) Insert(place, new Change(stamp, value, isResumed: true));
            else if (place > 0 && _changes[place - 1].Value == value) _changes[place - 1].Confirm(stamp);
            else Insert(place, stamp, value);
            return DropReason.None;
        }

        // Of two values with the same stamp, the one that arrives last applies, also in the gateway.
        DropReason Replace(int place, double value)
        {
            var former = _changes[place];
            if (former.Value == value) return DropReason.DuplicateSample;
            if (_isVisible && place == 0)
            {
                Insert(1, former.Stamp, value);
                return DropReason.None;
            }
            Remove(place);
            if (former.Confirmed > former.Stamp) place = Insert(place, former.Divide());
            Insert(place, new Change(former.Stamp, value, former.IsResumed));
            return DropReason.None;
        }

        void Insert(int place, ControlTime stamp, double value)
        {
            // The previous value was received again with a later stamp than the new value, so the signal had returned to the previous value by that
            // time.
            var isBetween = place > 0 && _changes[place - 1].Confirmed > stamp;
            if (isBetween) place = Insert(place, _changes[place - 1].Divide());
            // The next change has the same value, so the signal had this value since the new, earlier stamp. Moves that change to this stamp.
            else if (place < _count && _changes[place].Value == value)
            {
                _changes[place].MoveTo(stamp);
                return;
            }
            Insert(place, new Change(stamp, value));
        }

        // If the list is full, drops the oldest change that is not visible yet, because newer changes replace it.
        int Insert(int place, in Change change)
        {
            if (_count == Capacity)
            {
                var oldest = _isVisible ? 1 : 0;
                var isOldest = place <= oldest;
                var dropped = isOldest ? change : _changes[oldest];
                ref var next = ref _changes[isOldest ? oldest : oldest + 1];
                // A measured value that stays on one side has not switched unnoticed.
                if (dropped.IsResumed || IsOn(dropped.Value) != IsOn(Value)) next.Resume();
                Overflowed?.Invoke(this);
                if (isOldest) return place;
                Remove(oldest);
                place--;
            }
            for (var i = _count++; i > place; i--) _changes[i] = _changes[i - 1];
            _changes[place] = change;
            return place;
        }

        void Remove(int place)
        {
            _count--;
            for (var i = place; i < _count; i++) _changes[i] = _changes[i + 1];
        }

        struct Change
        {
            public Change(ControlTime stamp, double value, bool isResumed = false)
            {
                Stamp = Confirmed = stamp;
                Value = value;
                IsResumed = isResumed;
            }

            public ControlTime Stamp { get; private set; }
            public double Value { get; }

            /// <summary>Whether this is the first value that is kept after an interruption or after dropped changes.</summary>
            public bool IsResumed { get; private set; }

            /// <summary>Newest stamp with which the value was received.</summary>
            public ControlTime Confirmed { get; private set; }

            public void Confirm(ControlTime stamp)
            {
                if (stamp > Confirmed) Confirmed = stamp;
            }

            public void MoveTo(ControlTime stamp) => Stamp = stamp;

            public void Resume() => IsResumed = true;

            /// <summary>
            /// Returns a change to the same value at the stamp <see cref="Confirmed"/>, and resets <see cref="Confirmed"/> of this change to its own
            /// stamp.
            /// </summary>
            public Change Divide()
            {
                var confirmed = new Change(Confirmed, Value);
                Confirmed = Stamp;
                return confirmed;
            }
        }
    }
}
