using Nowpose.Session;
using Nowpose.Unity.Status;
using UnityEngine;

namespace Nowpose.Unity.Rendering
{
    /// <summary>How a pose is drawn, so that one that is not current cannot be taken for one: striped, with words, and mostly fainter.</summary>
    readonly struct PoseLook
    {
        /// <summary>No frame is computed any more; what was drawn last stays.</summary>
        public static readonly PoseLook Abandoned = new PoseLook("no session", "the session is disabled or paused", 0.8f);

        /// <summary>
        /// Minimum fade of a striped look: a part smaller than a stripe (1 cm) may lie wholly between two stripes, where only the fade shows.
        /// </summary>
        const float MinFadeWithStripes = 0.2f;

        PoseLook(string words, string reason, float fade, bool isDrawn = true, bool isHatched = true)
        {
            IsHatched = isHatched;
            Reason = reason;
            Words = words;
            Fade = isHatched ? Mathf.Max(fade, MinFadeWithStripes) : fade;
            IsDrawn = isDrawn;
        }

        /// <summary>Whether anything is drawn but the words.</summary>
        public bool IsDrawn { get; }

        /// <summary>0 (as it is) to 1 (hardly to be seen): the less is known, the more.</summary>
        public float Fade { get; }

        public bool IsHatched { get; }

        /// <summary>Empty where there is nothing to say.</summary>
        public string Words { get; }

        /// <summary>Why it is not plain; empty where it is.</summary>
        public string Reason { get; }

        /// <param name="outsideRange">How to look outside the range.</param>
        public static PoseLook Of(PoseState pose, OutsideRangeResponse outsideRange = OutsideRangeResponse.Fade)
        {
            var reason = StatusTexts.ReasonOf(pose);
            switch (pose)
            {
                case PoseState.Current: return new PoseLook("", reason, 0, isHatched: false);
                case PoseState.OutsideRange: return new PoseLook(PoseWords.Of(pose, outsideRange), reason, FadeOf(outsideRange));
                case PoseState.Held: return new PoseLook(PoseWords.Of(pose), reason, 0.5f);
                case PoseState.Unsynchronised: return new PoseLook(PoseWords.Of(pose), reason, 0.8f);
                // The joints stand at zero, where the robot is not.
                default: return new PoseLook(PoseWords.Of(pose), reason, 0.8f, isDrawn: false);
            }
        }

        static float FadeOf(OutsideRangeResponse outsideRange)
        {
            switch (outsideRange)
            {
                case OutsideRangeResponse.GoOn: return 0;
                case OutsideRangeResponse.Hold: return 0.5f;
                default: return 0.3f;
            }
        }

        /// <summary>The fade for a wearer who wants it fainter: what is not current never becomes fainter than the faintest of these looks.</summary>
        /// <param name="opacity">0 to 1 (as it is).</param>
        public float FadeAt(float opacity) => Mathf.Max(Fade, IsHatched ? Mathf.Min(1 - opacity, Abandoned.Fade) : 1 - opacity);

        /// <summary>The same for one more reason: at least as faint, striped, and what was wrong before is said first.</summary>
        public PoseLook Also(string words, string reason, float fade) => new PoseLook(
            Words.Length > 0 ? Words + ", " + words : words, Reason.Length > 0 ? Reason + "; " + reason : reason, Mathf.Max(Fade, fade), IsDrawn);

        /// <summary>The same for other words: of the parts that do not follow the pose, which are not drawn at all.</summary>
        public PoseLook Saying(string words, string reason) => new PoseLook(words, reason, Fade, IsDrawn, IsHatched);
    }
}
