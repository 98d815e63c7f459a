using Nowpose.Session;

namespace Nowpose.Unity.Calibration
{
    /// <summary>
    /// Converts the start of a frame to control time. A frame's timestamp code and its row in the log of a sweep contain this time.
    /// </summary>
    static class FrameControlTime
    {
        /// <param name="source">The session that computes the frame. Call this method while the frame is current.</param>
        /// <returns>
        /// Null unless the clock is synchronised. In holdover, the error of the control time may be ten times as large as the quantity to be
        /// measured.
        /// </returns>
        public static ControlTime? Of(MrilSession source, DisplayFrame frame)
        {
            if (source.Session == null) return null;
            var clock = source.Session.Clock.ModelAt(frame.Start);
            return clock.State == ClockState.Synchronised ? clock.ToControl(frame.Start) : (ControlTime?)null;
        }
    }
}
