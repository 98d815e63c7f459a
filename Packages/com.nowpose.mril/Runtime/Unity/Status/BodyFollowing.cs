using UnityEngine;

namespace Nowpose.Unity.Status
{
    /// <summary>
    /// Computes the pose of a panel that follows its reader. The panel stays in place in the world until the head has turned or moved too far.
    /// Then it glides to a place in front of the head and stays there.
    /// </summary>
    struct BodyFollowing
    {
        const float SettledDegrees = 0.5f;
        const float SettledMetres = 0.005f;

        bool _isPlaced;

        public bool IsGliding { get; private set; }

        /// <summary>Computes the pose of the panel for the next frame. The first call places the panel in front of the head.</summary>
        /// <param name="panel">Current pose of the panel.</param>
        /// <param name="head">Current pose of the head.</param>
        /// <param name="seconds">Duration of the frame in s.</param>
        /// <returns>The new pose; equal to <paramref name="panel"/> while the panel stays in place.</returns>
        public Pose Next(Pose panel, Pose head, in FollowSettings settings, float seconds)
        {
            var below = settings.DegreesBelow * Mathf.Deg2Rad;
            var goal = new AroundHead(
                AroundHead.HeadingOf(head.rotation), settings.Distance * Mathf.Cos(below), -settings.Distance * Mathf.Sin(below));
            if (!_isPlaced)
            {
                _isPlaced = true;
                return goal.From(head.position);
            }
            var place = AroundHead.Of(panel.position, head.position);
            if (!IsGliding && place.IsWithin(settings.TurnDegrees, settings.MoveMetres, goal)) return panel;
            // Continues a glide to its end. If the glide stopped as soon as the panel was within the limits, each small movement of the head would
            // start another glide.
            place = place.Towards(goal, 1 - Mathf.Exp(-seconds / settings.GlideSeconds));
            IsGliding = !place.IsWithin(SettledDegrees, SettledMetres, goal);
            return place.From(head.position);
        }
    }
}
