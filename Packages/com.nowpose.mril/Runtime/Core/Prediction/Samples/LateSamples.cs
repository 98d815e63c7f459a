using System;

namespace Nowpose.Prediction.Samples
{
    /// <summary>
    /// Samples of one joint that came in a row, each older than the newest and newer than the one before. Allocates nothing once made.
    /// </summary>
    sealed class LateSamples
    {
        /// <summary>
        /// Number of late samples in a row that proves a clock that went back: at 20 ms WiFi swaps two samples every few seconds.
        /// </summary>
        public const int Capacity = 5;

        /// <summary>Number that suffices where their positions contradict the samples around them.</summary>
        const int MinContradicted = 2;

        /// <summary>
        /// Number that suffices when they are late by more than <see cref="MaxDelay"/>. A single one may be a repeated message.
        /// </summary>
        const int MinFarBehind = 2;

        /// <summary>A network that is of any use delays no sample by more than this beyond those after it, s.</summary>
        const double MaxDelay = 0.25;

        readonly JointSample[] _oldestFirst = new JointSample[Capacity];
        readonly bool[] _areDropped = new bool[Capacity];
        int _count;
        int _contradicted;

        /// <summary>The oldest first.</summary>
        public ReadOnlySpan<JointSample> All => _oldestFirst.AsSpan(0, _count);

        /// <param name="index">In <see cref="All"/>.</param>
        public bool IsDropped(int index) => _areDropped[index];

        /// <summary>Whether a sample may be the next of a clock that went back.</summary>
        public bool IsContinuedBy(in JointSample sample) => _count == 0 || sample.Order > _oldestFirst[_count - 1].Order;

        /// <summary>Whether it is the same, sent again.</summary>
        public bool Contains(in JointSample sample)
        {
            foreach (ref readonly var late in All)
                if (RecentSamples.IsSame(late.Order, late.Position, sample)) return true;
            return false;
        }

        /// <summary>Adds a sample that is newer than the waiting ones.</summary>
        /// <param name="isDropped">Whether it is used only when the clock proves to have gone back.</param>
        /// <param name="isContradicted">Whether the samples around it say that the joint was elsewhere.</param>
        public void Add(in JointSample sample, bool isDropped, bool isContradicted)
        {
            _areDropped[_count] = isDropped;
            _oldestFirst[_count++] = sample;
            if (isContradicted) _contradicted++;
        }

        /// <param name="newest">Order of the newest sample, s.</param>
        public bool TellThatTimeWentBack(double newest) =>
            _count == Capacity || _contradicted == MinContradicted
            || (_count >= MinFarBehind && newest - _oldestFirst[_count - 1].Order > MaxDelay);

        public void Clear() => _count = _contradicted = 0;
    }
}
