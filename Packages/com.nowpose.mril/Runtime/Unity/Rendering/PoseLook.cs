using Nowpose.Session;
using Nowpose.Unity.Messages;
using UnityEngine;

namespace Nowpose.Unity.Rendering
{
    /// <summary>
    /// The look of a pose. A pose that is not current is striped, has a label, and is usually fainter than a current pose.
    /// </summary>
    readonly struct PoseLook
    {
        /// <summary>Look of the last pose while no more frames are computed.</summary>
        public static readonly PoseLook NoSession = new PoseLook(StatusMessages.NoSession, PoseMessages.SessionPaused, 0.8f);

        /// <summary>Look of an object that has not been placed yet. It is visible, so that the user can grasp it.</summary>
        public static readonly PoseLook Unplaced = new PoseLook(StatusMessages.NotPlaced, PoseMessages.NotPlaced, 0.5f);

        /// <summary>Fraction of the opacity that a part loses at a fade of 1, as in NowposePose.hlsl.</summary>
        public const float OpacityLoss = 0.8f;

        /// <summary>
        /// Minimum fade of a striped look. A part that is smaller than a stripe (1 cm) may lie between two stripes; then only the fade marks it.
        /// </summary>
        const float MinFadeWithStripes = 0.2f;

        PoseLook(string label, string reason, float fade, bool isDrawn = true, bool isHatched = true)
        {
            IsHatched = isHatched;
            Reason = reason;
            Label = label;
            Fade = isHatched ? Mathf.Max(fade, MinFadeWithStripes) : fade;
            IsDrawn = isDrawn;
        }

        /// <summary>Whether the parts are drawn. The text is always drawn.</summary>
        public bool IsDrawn { get; }

        /// <summary>Fade from 0 (unchanged) to 1 (hardly visible). It is larger for a less certain pose.</summary>
        public float Fade { get; }

        public bool IsHatched { get; }

        /// <summary>The text to show; empty for a current pose.</summary>
        public string Label { get; }

        /// <summary>Reason for the look; empty for a current pose.</summary>
        public string Reason { get; }

        /// <summary>Returns the look for the state of a pose.</summary>
        /// <param name="outsideRange">Response of the session outside the constant-latency range.</param>
        public static PoseLook Of(PoseState pose, OutsideRangeResponse outsideRange = OutsideRangeResponse.Fade)
        {
            var reason = StatusMessages.ReasonOf(pose);
            switch (pose)
            {
                case PoseState.Current: return new PoseLook("", reason, 0, isHatched: false);
                case PoseState.OutsideRange: return new PoseLook(PoseMessages.Of(pose, outsideRange), reason, FadeOf(outsideRange));
                case PoseState.Held: return new PoseLook(PoseMessages.Of(pose), reason, 0.5f);
                case PoseState.Unsynchronised: return new PoseLook(PoseMessages.Of(pose), reason, 0.8f);
                // The joint positions are unknown, so the rig is at zero. The robot must not be drawn in this pose.
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

        /// <summary>Returns the fade that keeps the product of what two fades keep, so that a part with both is fainter than with one.</summary>
        /// <param name="fade">Fade from 0 to 1, as is <paramref name="other"/>.</param>
        /// <returns>A value above 1 if the remaining opacity is less than a fifth.</returns>
        public static float Combined(float fade, float other) => fade + other * (1 - OpacityLoss * fade);

        /// <summary>
        /// Returns a striped look with an additional reason. Its fade is the larger of this look's fade and <paramref name="fade"/>. Its text and
        /// reason start with those of this look.
        /// </summary>
        public PoseLook Also(string label, string reason, float fade) => new PoseLook(
            Label.Length > 0 ? Label + ", " + label : label, Reason.Length > 0 ? Reason + "; " + reason : reason, Mathf.Max(Fade, fade), IsDrawn);

        /// <summary>Returns this look with another label and reason.</summary>
        public PoseLook With(string label, string reason) => new PoseLook(label, reason, Fade, IsDrawn, IsHatched);
    }
}
