using Nowpose.Anchoring;
using Nowpose.Unity.Messages;

namespace Nowpose.Unity.Rendering
{
    /// <summary>
    /// Changes the look of a robot or object while the pose of the base is uncertain. The robot and all objects may then be displaced.
    /// </summary>
    readonly struct BaseLook
    {
        readonly BaseAnchorState _state;
        readonly bool _isBeingPlaced;
        readonly string _problem;

        BaseLook(BaseAnchor anchor)
        {
            _state = anchor.State;
            _problem = anchor.Problem;
            _isBeingPlaced = _problem == null && anchor.Tracker != null && anchor.Tracker.IsBeingPlaced;
        }

        /// <param name="anchor">The anchor of the base; null if there is none. Without an anchor, the user has placed the robot by hand.</param>
        public static BaseLook Of(BaseAnchor anchor) => anchor != null ? new BaseLook(anchor) : default;

        public bool IsSameAs(BaseLook other) =>
            _state == other._state && _isBeingPlaced == other._isBeingPlaced && ReferenceEquals(_problem, other._problem);

        public PoseLook Over(PoseLook look)
        {
            switch (_state)
            {
                // The robot does not fade while the user places the base: the user must compare the displayed robot with the real robot.
                case BaseAnchorState.Searching:
                    return _isBeingPlaced
                        ? look.Also(BaseMessages.BeingPlacedLabel, BaseMessages.FollowsMarker, 0)
                        : look.Also(BaseMessages.NotLockedLabel, _problem ?? BaseMessages.NotLocated, 0.8f);
                case BaseAnchorState.Restored: return look.Also(BaseMessages.NotConfirmedLabel, BaseMessages.Restored, 0);
                case BaseAnchorState.Moved: return look.Also(BaseMessages.MovedLabel, BaseMessages.Moved, 0.5f);
                case BaseAnchorState.Lost: return look.Also(BaseMessages.LostLabel, BaseMessages.Lost, 0.5f);
                default: return look;
            }
        }
    }
}
