using Nowpose.Session;

namespace Nowpose.Unity
{
    /// <summary>How a pose is drawn, so that one that is not current cannot be taken for one: fainter, striped and with words.</summary>
    readonly struct PoseLook
    {
        /// <summary>No frame is computed any more; what was drawn last stays.</summary>
        public static readonly PoseLook Abandoned = new PoseLook("no session", 0.8f);

        /// <summary>The rig does not follow the session: it stands wherever it was, and that may be anywhere.</summary>
        public static readonly PoseLook Unmoved = new PoseLook("rig not moved", 0.8f, isDrawn: false);

        PoseLook(string words, float fade, bool isDrawn = true)
        {
            Words = words;
            Fade = fade;
            IsDrawn = isDrawn;
        }

        /// <summary>Whether anything is drawn but the words.</summary>
        public bool IsDrawn { get; }

        /// <summary>0 (as it is) to 1 (hardly to be seen): the less is known, the more.</summary>
        public float Fade { get; }

        public bool IsHatched => Fade > 0;

        /// <summary>Empty where there is nothing to say.</summary>
        public string Words { get; }

        public static PoseLook Of(PoseState pose)
        {
            switch (pose)
            {
                case PoseState.Current: return new PoseLook("", 0);
                case PoseState.OutsideRange: return new PoseLook("outside range", 0.3f);
                case PoseState.Held: return new PoseLook("held", 0.5f);
                case PoseState.Unsynchronised: return new PoseLook("not synchronised", 0.8f);
                // The joints stand at zero, where the robot is not.
                default: return new PoseLook("no positions yet", 0.8f, isDrawn: false);
            }
        }
    }
}
