using UnityEngine;

namespace Nowpose.Unity.Status
{
    /// <summary>
    /// Where a panel stands that follows its reader's body: it stays put in the world until the head has turned or moved too
    /// far, then glides over in front of it, and stays again.
    /// </summary>
    struct BodyFollowing
    {
        const float SettledDegrees = 0.5f;
        const float SettledMetres = 0.005f;

        bool _isPlaced;

        public bool IsGliding { get; private set; }

        /// <returns>The pose it is to have; exactly the one it has, unless it glides. At first in front of the head at once.</returns>
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
            // Once it moves it moves until it is there, or it would stop at the edge and start again with every nod.
            place = place.Towards(goal, 1 - Mathf.Exp(-seconds / settings.GlideSeconds));
            IsGliding = !place.IsWithin(SettledDegrees, SettledMetres, goal);
            return place.From(head.position);
        }
    }
}
