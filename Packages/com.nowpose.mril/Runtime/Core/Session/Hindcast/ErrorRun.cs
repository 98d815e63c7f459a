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
        readonly ErrorTotals _totals = new ErrorTotals();
        int _count;
        int _framesPerBatch = FramesPerFirstBatch;

        public void Add(in ErrorSums frame)
        {
            if (_count == 0 || _batches[_count - 1].Count >= _framesPerBatch) BeginBatch();
            _batches[_count - 1].Add(frame);
            _totals.Add(frame);
        }

        /// <returns>Null without a frame.</returns>
        public DisplayedError? Read() => _totals.Read(_batches.AsSpan(0, _count));

        public void Reset()
        {
            _totals.Clear();
            _count = 0;
            _framesPerBatch = FramesPerFirstBatch;
        }

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
