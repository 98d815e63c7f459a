using System;

namespace Nowpose.Latency
{
    /// <summary>Decides which of several ways to measure the render time is in use.</summary>
    /// <remarks>
    /// What a device can measure shows only while it runs, and it may fall silent. A way is used from its thirtieth time on
    /// while no better one has begun to give times, and given up after thirty frames without any; so the choice does not go
    /// back and forth, which would start the judgement of the range anew each time. Allocates nothing once made; one thread.
    /// </remarks>
    sealed class RenderTimeChoice
    {
        const int TimesToTrust = 30;
        const int FramesToGiveUp = 30;
        const int None = -1;

        readonly Candidate[] _candidates;
        int _inUse = None;

        /// <param name="bestFirst">What each way measures.</param>
        public RenderTimeChoice(params RenderTimeSourceKind[] bestFirst)
        {
            _candidates = new Candidate[bestFirst.Length];
            for (var i = 0; i < bestFirst.Length; i++) _candidates[i].Kind = bestFirst[i];
        }

        /// <summary>What is in use; <see cref="RenderTimeSourceKind.None"/> before the first is trusted and after the last fell silent.</summary>
        public RenderTimeSourceKind Source => _inUse == None ? RenderTimeSourceKind.None : _candidates[_inUse].Kind;

        /// <summary>The render time that the way in use gave in the frame that ended last; null when it gave none.</summary>
        public TimeSpan? RenderTime { get; private set; }

        /// <summary>A render time that became known in this frame; of several by the same way the last counts.</summary>
        /// <param name="candidate">Index of the way among those of the constructor.</param>
        /// <param name="renderTime">Zero or less says nothing: so do drivers that do not measure.</param>
        public void Report(int candidate, TimeSpan renderTime)
        {
            if (renderTime > TimeSpan.Zero) _candidates[candidate].Newest = renderTime;
        }

        /// <summary>All times of this frame were reported.</summary>
        /// <returns>Whether <see cref="Source"/> has changed.</returns>
        public bool EndFrame()
        {
            var before = Source;
            for (var i = 0; i < _candidates.Length; i++) _candidates[i].Count();
            if (_inUse != None && _candidates[_inUse].Times == 0) _inUse = None;
            var better = FirstThatGivesTimes();
            if (better != None && _candidates[better].Times >= TimesToTrust) _inUse = better;
            RenderTime = _inUse == None ? null : _candidates[_inUse].Newest;
            for (var i = 0; i < _candidates.Length; i++) _candidates[i].Newest = null;
            return Source != before;
        }

        // One that has just begun keeps worse ones from being chosen, but not the one in use.
        int FirstThatGivesTimes()
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
