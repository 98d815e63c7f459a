using System;

namespace Nowpose.Latency
{
    /// <summary>Selects one of several render-time sources.</summary>
    /// <remarks>
    /// Only a running application shows which sources a device supports, and a source may stop delivering render times. A source is selected after
    /// its 30th render time if no better source has started to deliver render times. It is dropped after 30 frames without a render time. This
    /// prevents an alternating selection, which would restart the range monitor at each change. Allocates nothing after construction;
    /// single-threaded.
    /// </remarks>
    sealed class RenderTimeChoice
    {
        const int TimesToTrust = 30;
        const int FramesToGiveUp = 30;
        const int None = -1;

        readonly Candidate[] _candidates;
        int _inUse = None;

        /// <param name="bestFirst">Kinds of the sources, in descending order of preference.</param>
        public RenderTimeChoice(params RenderTimeSourceKind[] bestFirst)
        {
            _candidates = new Candidate[bestFirst.Length];
            for (var i = 0; i < bestFirst.Length; i++) _candidates[i].Kind = bestFirst[i];
        }

        /// <summary>Selected source; <see cref="RenderTimeSourceKind.None"/> before the first selection and after the source was dropped.</summary>
        public RenderTimeSourceKind Source => _inUse == None ? RenderTimeSourceKind.None : _candidates[_inUse].Kind;

        /// <summary>Render time that the selected source delivered in the newest completed frame; null if it delivered none.</summary>
        public TimeSpan? RenderTime { get; private set; }

        /// <summary>
        /// Reports a render time that became known in this frame. If a source reports several render times in a frame, the last is used.
        /// </summary>
        /// <param name="candidate">Index of the source in the constructor's list.</param>
        /// <param name="renderTime">Zero and negative values are ignored: drivers that do not measure report zero.</param>
        public void Report(int candidate, TimeSpan renderTime)
        {
            if (renderTime > TimeSpan.Zero) _candidates[candidate].Newest = renderTime;
        }

        /// <summary>Ends the frame. Call it after all render times of the frame were reported.</summary>
        /// <returns>Whether <see cref="Source"/> has changed.</returns>
        public bool EndFrame()
        {
            var before = Source;
            for (var i = 0; i < _candidates.Length; i++) _candidates[i].Count();
            if (_inUse != None && _candidates[_inUse].Times == 0) _inUse = None;
            var better = BestActive();
            if (better != None && _candidates[better].Times >= TimesToTrust) _inUse = better;
            RenderTime = _inUse == None ? null : _candidates[_inUse].Newest;
            for (var i = 0; i < _candidates.Length; i++) _candidates[i].Newest = null;
            return Source != before;
        }

        // A source that has just started prevents the selection of a worse source but does not replace the selected source.
        int BestActive()
        {
            var end = _inUse == None ? _candidates.Length : _inUse;
            for (var i = 0; i < end; i++)
                if (_candidates[i].Times > 0) return i;
            return None;
        }

        struct Candidate
        {
            public RenderTimeSourceKind Kind;
            public TimeSpan? Newest;
            public int Times;
            int _silentFrames;

            public void Count()
            {
                _silentFrames = Newest.HasValue ? 0 : _silentFrames + 1;
                if (Newest.HasValue) Times = Math.Min(Times + 1, TimesToTrust);
                else if (_silentFrames >= FramesToGiveUp) Times = 0;
            }
        }
    }
}
