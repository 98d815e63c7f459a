using System;
using Nowpose.Prediction;

namespace Nowpose.Session
{
    /// <summary>Samples of one joint that came in a row, each older than the newest and newer than the one before. Allocates nothing once made.</summary>
    sealed class LateSamples
    {
        /// <summary>So many in a row are a clock that went back: at a sample every 20 ms WiFi turns two around every few seconds.</summary>
        const int Most = 5;

        /// <summary>So many suffice where the joint was not where they say: a clock of another time, soon to tear the section apart.</summary>
        const int FewestContradicted = 2;

        /// <summary>So many suffice when they are late by more than <see cref="GreatestDelay"/>; a single one was sent again.</summary>
        const int FewestFarBehind = 2;

        /// <summary>A network that is of any use delays no sample by more than this beyond those after it, s.</summary>
        const double GreatestDelay = 0.25;

        readonly JointSample[] _oldestFirst = new JointSample[Most];
        int _count;
        int _contradicted;

        /// <summary>The oldest first.</summary>
        public ReadOnlySpan<JointSample> All => _oldestFirst.AsSpan(0, _count);

        /// <summary>Whether a sample may be the next of a clock that went back.</summary>
        public bool IsContinuedBy(in JointSample sample) => _count == 0 || sample.Order > _oldestFirst[_count - 1].Order;

        /// <summary>Whether it is the same, sent again.</summary>
        public bool Contains(in JointSample sample)
        {
            foreach (ref readonly var late in All)
                if (RecentSamples.IsSame(late.Order, late.Position, sample)) return true;
            return false;
        }

        /// <summary>Takes a sample that continues the others, which have not told yet that time went back.</summary>
        /// <param name="isContradicted">Whether the samples around it say that the joint was elsewhere.</param>
        public void Add(in JointSample sample, bool isContradicted)
        {
            _oldestFirst[_count++] = sample;
            if (isContradicted) _contradicted++;
        }

        /// <param name="newest">What sorts the newest sample, s.</param>
        public bool TellThatTimeWentBack(double newest) =>
            _count == Most || _contradicted == FewestContradicted
            || (_count >= FewestFarBehind && newest - _oldestFirst[_count - 1].Order > GreatestDelay);

        public void Clear() => _count = _contradicted = 0;
    }
}
