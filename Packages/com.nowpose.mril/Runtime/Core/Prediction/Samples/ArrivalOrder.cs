using System;

namespace Nowpose.Prediction.Samples
{
    /// <summary>Limits that distinguish late samples, and late values of signals, from a clock that went back.</summary>
    static class ArrivalLimits
    {
        /// <summary>
        /// Number of consecutive late samples that proves that the clock went back: at 20 ms, WiFi swaps two samples every few seconds.
        /// </summary>
        public const int MinLateForRestart = 5;

        /// <summary>
        /// Maximum delay of a sample relative to later ones on a usable network, in s. A later sample would hardly improve a prediction, whose
        /// default horizon cap is 0.3 s.
        /// </summary>
        public const double MaxDelay = 0.25;

        /// <summary>Returns whether a stamp is older than the newest one by more than <see cref="MaxDelay"/>.</summary>
        public static bool IsFarBehind(ControlTime stamp, ControlTime newest) => ClockTicks.Seconds(newest - stamp) > MaxDelay;
    }

    /// <summary>
    /// Distinguishes samples that were overtaken on the network from samples whose clock went back.
    /// </summary>
    /// <remarks>
    /// In both cases, the stamp of the sample is not newer than the newest one. Both mistakes are costly: a sample of another clock makes the section
    /// wrong, and a restart discards all that was learned. Therefore up to four late samples wait for the next samples, which decide:
    /// <list type="bullet">
    /// <item><description>
    /// They were overtaken if the next sample is newer than the newest one, or not newer than the last that waits. They are then inserted, except those
    /// whose positions contradict their neighbours, because their stamps are wrong. But if a newer sample shows that only the stamp of the newest one
    /// before it was wrong (<see cref="RecentSamples{TSample}.HasWrongNewestStamp"/>), its sample is discarded.
    /// </description></item>
    /// <item><description>
    /// They were not overtaken if there are five, or two that contradict their neighbours, or two that are late by more than
    /// <see cref="ArrivalLimits.MaxDelay"/>. If all of them are newer than the sample before the newest, only the newest stamp was wrong, and its sample is
    /// discarded. Otherwise the clock went back, and the history restarts with them.
    /// </description></item>
    /// </list>
    /// </remarks>
    sealed class ArrivalOrder<TSample> where TSample : struct, ISample<TSample>
    {
        /// <summary>
        /// Number of consecutive late samples that is sufficient if the neighbouring samples show that the joint was elsewhere, or if the samples are
        /// late by more than <see cref="ArrivalLimits.MaxDelay"/>. A single one may be a repeated message.
        /// </summary>
        const int MinClearlyLateForRestart = 2;

        readonly RecentSamples<TSample> _recent;
        readonly TSample[] _ready = new TSample[ArrivalLimits.MinLateForRestart + 1];
        double _newest = double.NegativeInfinity, _beforeNewest = double.NegativeInfinity;
        int _readyCount;

        // The waiting samples, each newer than the previous one. Some are only evidence: they are used only if the clock has gone back.
        readonly TSample[] _late = new TSample[ArrivalLimits.MinLateForRestart];
        readonly bool[] _isOnlyEvidence = new bool[ArrivalLimits.MinLateForRestart];
        int _lateCount, _contradicted;

        /// <param name="isEndless">Whether positions are angles in rad that may wrap from π to −π.</param>
        public ArrivalOrder(bool isEndless) => _recent = new RecentSamples<TSample>(isEndless);

        /// <summary>
        /// Samples to use now, in order: the waiting samples that are now classified, and the added sample if it is the newest.
        /// </summary>
        public ReadOnlySpan<TSample> Ready => _ready.AsSpan(0, _readyCount);

        /// <summary>Number of times that the samples showed that the clock went back; all earlier samples are then invalid.</summary>
        public int Restarts { get; private set; }

        /// <summary>
        /// Whether the last added sample showed that the newest stamp before it was wrong, because it was too far in the future. The sample with this stamp is
        /// then invalid.
        /// </summary>
        public bool IsNewestStampWrong { get; private set; }

        /// <summary>Adds a sample, which may be ready at once, wait, or be dropped.</summary>
        /// <returns>
        /// Reason why the sample is used only if the clock went back. <see cref="DropReason.None"/> also means that the sample waits; if it never
        /// becomes ready, it still counts as used.
        /// </returns>
        /// <param name="oldest">
        /// Order below which samples are too old for the prediction, in s; they are still evidence of a clock that went back.
        /// </param>
        public DropReason Add(in TSample sample, double oldest)
        {
            _readyCount = 0;
            IsNewestStampWrong = false;
            if (sample.Order > _newest && !JointSample.IsSameTime(_newest, sample.Order))
            {
                IsNewestStampWrong = AreLateBeforeNewest && _recent.HasWrongNewestStamp(_late.AsSpan(0, _lateCount), sample);
                if (IsNewestStampWrong) Forget();
                ReleaseLate(withEvidence: IsNewestStampWrong);
                Release(sample);
                return DropReason.None;
            }
            // The stamp alone is not sufficient: a clock that goes back by whole sampling intervals repeats earlier stamps with other positions.
            var isKnown = _recent.Contains(sample, out var isRepeated);
            if (isRepeated || IsWaiting(sample)) return DropReason.DuplicateSample;
            if (_lateCount > 0 && sample.Order <= _late[_lateCount - 1].Order) ReleaseLate(withEvidence: false);
            var contradicts = _recent.Contradict(sample);
            if (contradicts) _contradicted++;
            var reason = sample.Order < oldest ? DropReason.LateSample
                : isKnown ? DropReason.DuplicateSample
                : contradicts ? DropReason.LateSample : DropReason.None;
            _isOnlyEvidence[_lateCount] = reason != DropReason.None;
            _late[_lateCount++] = sample;
            if (MustWait) return reason;
            IsNewestStampWrong = AreLateBeforeNewest;
            if (!IsNewestStampWrong) Restarts++;
            Forget();
            ReleaseLate(withEvidence: true);
            return DropReason.None;
        }

        public void Clear()
        {
            Forget();
            _readyCount = _lateCount = _contradicted = 0;
        }

        // Whether there are waiting samples, all of them newer than the sample before the newest.
        bool AreLateBeforeNewest =>
            _lateCount > 0 && !double.IsNegativeInfinity(_beforeNewest) && _late[0].Order - _beforeNewest >= JointSample.SameSeconds;

        bool MustWait => _lateCount < ArrivalLimits.MinLateForRestart && _contradicted < MinClearlyLateForRestart
            && (_lateCount < MinClearlyLateForRestart || _newest - _late[_lateCount - 1].Order <= ArrivalLimits.MaxDelay);

        void Forget()
        {
            _recent.Clear();
            _newest = _beforeNewest = double.NegativeInfinity;
        }

        bool IsWaiting(in TSample sample)
        {
            for (var i = 0; i < _lateCount; i++)
                if (JointSample.IsSameTime(_late[i].Order, sample.Order) && RecentSamples<TSample>.HasSameComponents(_late[i], sample)) return true;
            return false;
        }

        void ReleaseLate(bool withEvidence)
        {
            for (var i = 0; i < _lateCount; i++)
                if (withEvidence || !_isOnlyEvidence[i]) Release(_late[i]);
            _lateCount = _contradicted = 0;
        }

        void Release(in TSample sample)
        {
            if (sample.Order > _newest) (_beforeNewest, _newest) = (_newest, sample.Order);
            _recent.Add(sample);
            _ready[_readyCount++] = sample;
        }
    }
}
