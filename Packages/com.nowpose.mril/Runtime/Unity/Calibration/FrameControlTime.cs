using Nowpose.Session;

namespace Nowpose.Unity.Calibration
{
    /// <summary>C2 mapped to C1: what a frame's timestamp code shows, and what a sweep's log says of the same frame.</summary>
    static class FrameControlTime
    {
        /// <param name="source">Whose frame it is, while it is shown.</param>
        /// <returns>Null unless the clock is synchronised: in a holdover it may be ten times as wrong as what is measured with it.</returns>
        public static ControlTime? Of(MrilSession source, DisplayFrame frame)
        {
            if (source.Session == null) return null;
            var clock = source.Session.Clock.ModelAt(frame.Start);
            return clock.State == ClockState.Synchronised ? clock.ToControl(frame.Start) : (ControlTime?)null;
        }
    }
}
