using System;
using Nowpose.Prediction;
using Nowpose.Protocol;

namespace Nowpose.Session
{
    /// <summary>How many samples that had waited for a newer one were of no use in the end, by reason.</summary>
    readonly struct UselessSamples
    {
        readonly int _tooOld;
        readonly int _duplicates;

        UselessSamples(int tooOld, int duplicates)
        {
            _tooOld = tooOld;
            _duplicates = duplicates;
        }

        /// <summary>With one more sample, if that is the outcome of a useless one.</summary>
        public UselessSamples With(SampleOutcome outcome) => new UselessSamples(
            _tooOld + (outcome == SampleOutcome.TooOld ? 1 : 0), _duplicates + (outcome == SampleOutcome.Duplicate ? 1 : 0));

        /// <summary>Of each reason the more: the joints' samples came in the same messages, and messages are counted.</summary>
        public static UselessSamples Most(in UselessSamples a, in UselessSamples b) =>
            new UselessSamples(Math.Max(a._tooOld, b._tooOld), Math.Max(a._duplicates, b._duplicates));

        public void CountIn(DropCounters drops)
        {
            drops.Count(DropReason.LateSample, _tooOld);
            drops.Count(DropReason.DuplicateSample, _duplicates);
        }
    }
}
