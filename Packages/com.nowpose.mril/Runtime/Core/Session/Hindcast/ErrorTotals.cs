using System;

namespace Nowpose.Session.Hindcast
{
    /// <summary>Sums and histograms of the errors of one quantity over frames. Allocates nothing after construction.</summary>
    sealed class ErrorTotals
    {
        readonly ErrorHistogram _displayed = new ErrorHistogram();
        readonly ErrorHistogram _held = new ErrorHistogram();
        ErrorSums _sums;

        public ErrorSums Sums => _sums;

        /// <param name="frame">Errors of one frame.</param>
        public void Add(in ErrorSums frame)
        {
            _sums.Add(frame);
            _displayed.Add(frame.Displayed);
            _held.Add(frame.Held);
        }

        public void Add(ErrorTotals other)
        {
            _sums.Add(other._sums);
            _displayed.Add(other._displayed);
            _held.Add(other._held);
        }

        public void Clear()
        {
            _sums = default;
            _displayed.Clear();
            _held.Clear();
        }

        /// <param name="batches">Sums over groups of the frames that are nearly independent.</param>
        /// <returns>Null without a frame.</returns>
        public DisplayedError? Read(ReadOnlySpan<ErrorSums> batches) => _sums.Count == 0 ? (DisplayedError?)null : new DisplayedError(
            _sums.Count, Math.Sqrt(_sums.Displayed / _sums.Count), _displayed.At(0.95), Math.Sqrt(_sums.Held / _sums.Count), _held.At(0.95),
            ReductionEstimate.Of(_sums), ReductionEstimate.UncertaintyOf(_sums, batches),
            Math.Sqrt(_sums.Truth / _sums.Count), Math.Sqrt(_sums.Clock / _sums.Count));
    }
}
