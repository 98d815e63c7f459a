using Nowpose.Session;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Status;
using UnityEngine;

namespace Nowpose.Unity.Rendering
{
    /// <summary>The look of a pose. One that is not current is clearly different: striped, with words, and usually fainter.</summary>
    readonly struct PoseLook
    {
        /// <summary>No frames are computed; the last pose stays visible.</summary>
        public static readonly PoseLook Abandoned = new PoseLook("no session", PoseMessages.SessionPaused, 0.8f);

        /// <summary>An object that waits for its place; visible, so that a hand can take it.</summary>
        public static readonly PoseLook Unplaced = new PoseLook("not placed", PoseMessages.NotPlaced, 0.5f);

        /// <summary>
        /// Minimum fade of a striped look: a part smaller than a stripe (1 cm) may be between two stripes, so that only the fade is visible.
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

        /// <summary>Whether anything except the words is drawn.</summary>
        public bool IsDrawn { get; }

        /// <summary>0 (unchanged) to 1 (hardly visible); larger for a less certain pose.</summary>
        public float Fade { get; }

        public bool IsHatched { get; }

        /// <summary>The words to show; empty if there are none.</summary>
        public string Words { get; }

        /// <summary>Why the look is not plain; empty if it is.</summary>
        public string Reason { get; }

        /// <param name="outsideRange">The response outside the constant-latency range.</param>
        public static PoseLook Of(PoseState pose, OutsideRangeResponse outsideRange = OutsideRangeResponse.Fade)
        {
            var reason = StatusTexts.ReasonOf(pose);
            switch (pose)
            {
                case PoseState.Current: return new PoseLook("", reason, 0, isHatched: false);
                case PoseState.OutsideRange: return new PoseLook(PoseMessages.Of(pose, outsideRange), reason, FadeOf(outsideRange));
                case PoseState.Held: return new PoseLook(PoseMessages.Of(pose), reason, 0.5f);
                case PoseState.Unsynchronised: return new PoseLook(PoseMessages.Of(pose), reason, 0.8f);
                // The robot is not drawn, because the joints are at zero instead of the robot's positions.
                default: return new PoseLook(PoseMessages.Of(pose), reason, 0.8f, isDrawn: false);
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

        /// <summary>Returns the fade for a reduced opacity; a pose that is not current never gets fainter than the faintest of these looks.</summary>
        /// <param name="opacity">0 to 1 (unchanged).</param>
        public float FadeAt(float opacity) => Mathf.Max(Fade, IsHatched ? Mathf.Min(1 - opacity, Abandoned.Fade) : 1 - opacity);

        /// <summary>Adds a reason: at least the given fade, striped, with the earlier words first.</summary>
        public PoseLook Also(string words, string reason, float fade) => new PoseLook(
            Words.Length > 0 ? Words + ", " + words : words, Reason.Length > 0 ? Reason + "; " + reason : reason, Mathf.Max(Fade, fade), IsDrawn);

        /// <summary>Replaces the words, for parts that do not follow the pose and are not drawn.</summary>
        public PoseLook With(string words, string reason) => new PoseLook(words, reason, Fade, IsDrawn, IsHatched);
    }
}
