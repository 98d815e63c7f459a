using Nowpose.Session;

namespace Nowpose.Unity
{
    /// <summary>C2 mapped to C1: what a frame's timestamp code shows, and what a sweep's log says of the same frame.</summary>
    static class FrameControlTime
    {
        /// <param name="source">Whose frame it is, while it is shown.</param>
        /// <returns>Null while the control time is not known well enough to show a pose as current.</returns>
        public static ControlTime? Of(MrilSession source, DisplayFrame frame)
        {
            if (!frame.IsTimeTrusted || source.Session == null) return null;
            var clock = source.Session.Clock.ModelAt(frame.Start);
            return clock.IsKnown ? clock.ToControl(frame.Start) : (ControlTime?)null;
        }
    }
}
