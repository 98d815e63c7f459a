using Nowpose.Session;

namespace Nowpose.Unity
{
    /// <summary>Reports the conditions of this device to a session: at its start, and again while the display starts.</summary>
    struct DeviceWatch
    {
        /// <summary>A display begins some frames after the scene, and only then reports its rate.</summary>
        const int FramesBetweenLooks = 60, MaxLooks = 10;

        int _frames;

        public void Begin(CompensationSession session)
        {
            _frames = 0;
            session.Conditions = ThisDevice.Conditions;
        }

        /// <summary>Once a frame. Allocates only in the frames in which it looks.</summary>
        public void Follow(CompensationSession session)
        {
            if (_frames < FramesBetweenLooks * MaxLooks && ++_frames % FramesBetweenLooks == 0) session.Conditions = ThisDevice.Conditions;
        }
    }
}
