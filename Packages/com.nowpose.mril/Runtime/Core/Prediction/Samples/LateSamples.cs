using System;

namespace Nowpose.Prediction.Samples
{
    /// <summary>
    /// Consecutive late samples of one joint: older than the newest sample, and each newer than the previous one. Allocates nothing after construction.
    /// </summary>
    sealed class LateSamples
    {
        /// <summary>
        /// Number of consecutive late samples that proves a clock that went back: at 20 ms, WiFi swaps two samples every few seconds.
        /// </summary>
        public const int Capacity = 5;

        /// <summary>Sufficient number if their positions contradict the neighbouring samples.</summary>
        const int MinContradicted = 2;

        /// <summary>
        /// Number of late samples that is sufficient if they are late by more than <see cref="MaxDelay"/>. A single one may be a repeated message.
        /// </summary>
        const int MinFarBehind = 2;

        /// <summary>Maximum delay of a sample relative to later ones on a usable network, in s.</summary>
        const double MaxDelay = 0.25;

        readonly JointSample[] _oldestFirst = new JointSample[Capacity];
        readonly bool[] _areDropped = new bool[Capacity];
        int _count;
        int _contradicted;

        /// <summary>The waiting samples, oldest first.</summary>
        public ReadOnlySpan<JointSample> All => _oldestFirst.AsSpan(0, _count);

        /// <param name="index">Index in <see cref="All"/>.</param>
        public bool IsDropped(int index) => _areDropped[index];

        /// <summary>Returns whether a sample may be the next one of a clock that went back.</summary>
        public bool IsContinuedBy(in JointSample sample) => _count == 0 || sample.Order > _oldestFirst[_count - 1].Order;

        /// <summary>Returns whether the sample is a repetition of a waiting one.</summary>
        public bool Contains(in JointSample sample)
        {
            foreach (ref readonly var late in All)
                if (RecentSamples.IsSame(late.Order, late.Position, sample)) return true;
            return false;
        }

        /// <summary>Adds a sample that is newer than the waiting ones.</summary>
        /// <param name="isDropped">Whether it is used only if the clock has gone back.</param>
        /// <param name="isContradicted">Whether the neighbouring samples show that the joint was elsewhere.</param>
        public void Add(in JointSample sample, bool isDropped, bool isContradicted)
        {
            _areDropped[_count] = isDropped;
            _oldestFirst[_count++] = sample;
            if (isContradicted) _contradicted++;
        }

        /// <param name="newest">Order time of the newest sample in the history, s.</param>
        public bool HasTimeGoneBack(double newest) =>
            _count == Capacity || _contradicted == MinContradicted
            || (_count >= MinFarBehind && newest - _oldestFirst[_count - 1].Order > MaxDelay);

        public void Clear() => _count = _contradicted = 0;
    }
}
