using System;

namespace Nowpose.Session.Hindcast
{
    /// <summary>Errors of one quantity over a run of any length. Allocates nothing after construction.</summary>
    /// <remarks>
    /// When the maximum number of batches is reached, adjacent batches are merged, so that the batches become larger and their number stays
    /// limited.
    /// </remarks>
    sealed class ErrorRun
    {
        const int MaxBatches = 32;

        /// <summary>Initial number of frames in a batch: about one second.</summary>
        const int FramesPerFirstBatch = 64;

        readonly ErrorSums[] _batches = new ErrorSums[MaxBatches];
        readonly ErrorHistogram _displayed = new ErrorHistogram();
        readonly ErrorHistogram _held = new ErrorHistogram();
        ErrorSums _sums;
        int _count;
        int _framesPerBatch = FramesPerFirstBatch;

        public void Add(in ErrorSample sample)
        {
            if (_count == 0 || _batches[_count - 1].Count >= _framesPerBatch) BeginBatch();
            _batches[_count - 1].Add(sample);
            _sums.Add(sample);
            _displayed.Add(sample.DisplayedSquared);
            _held.Add(sample.HeldSquared);
        }

        /// <returns>Null without a sample.</returns>
        public DisplayedError? Read() => _sums.Count == 0 ? (DisplayedError?)null : Of(_sums, _displayed, _held, _batches.AsSpan(0, _count));

        public void Reset()
        {
            _sums = default;
            _count = 0;
            _framesPerBatch = FramesPerFirstBatch;
            _displayed.Clear();
            _held.Clear();
        }

        internal static DisplayedError Of(
            in ErrorSums sums, ErrorHistogram displayed, ErrorHistogram held, ReadOnlySpan<ErrorSums> batches) => new DisplayedError(
                sums.Count, Math.Sqrt(sums.Displayed / sums.Count), displayed.At(0.95), Math.Sqrt(sums.Held / sums.Count), held.At(0.95),
                ReductionEstimate.Of(sums), ReductionEstimate.UncertaintyOf(sums, batches),
                Math.Sqrt(sums.Truth / sums.Count), Math.Sqrt(sums.Clock / sums.Count));

        void BeginBatch()
        {
            if (_count == MaxBatches)
            {
                for (var i = 0; i < MaxBatches / 2; i++)
                {
                    var pair = _batches[2 * i];
                    pair.Add(_batches[2 * i + 1]);
                    _batches[i] = pair;
                }
                _count /= 2;
                _framesPerBatch *= 2;
            }
            _batches[_count++] = default;
        }
    }
}
