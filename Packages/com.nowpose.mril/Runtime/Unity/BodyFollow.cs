using Nowpose.Unity.Status;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>
    /// Keeps an object in front of its reader without fixing it to the head: it stays in place until the head has turned or moved too
    /// far, then glides to the new place. Always upright.
    /// </summary>
    [AddComponentMenu("Nowpose/Body Follow")]
    [DefaultExecutionOrder(MrilSession.ExecutionOrder + 1)]
    [DisallowMultipleComponent]
    public sealed class BodyFollow : MonoBehaviour
    {
        [SerializeField, Tooltip("Whom it follows. Empty: the main camera, which is the wearer's head.")]
        Transform _head = null;

        [SerializeField, Range(0.5f, 5), Tooltip("Metres from the head. 1.3: a headset's picture is sharp at an arm's length and more.")]
        float _distanceMetres = 1.3f;

        [SerializeField, Range(-30, 45), Tooltip("Degrees below the height of the eyes. 6: the whole status panel is in a HoloLens 2's view.")]
        float _degreesBelow = 6;

        [SerializeField, Range(5, 90), Tooltip("Degrees that the head may turn to either side before it follows. 35: looking to and fro along a "
            + "robot does not move it.")]
        float _turnDegrees = 35;

        [SerializeField, Range(0.05f, 2), Tooltip("Metres that the head may come nearer, go farther, rise or sink before it follows. 0.4: shifting "
            + "one's weight does not move it.")]
        float _moveMetres = 0.4f;

        [SerializeField, Range(0.05f, 2), Tooltip("Seconds in which it does two thirds of its way. 0.4: quick to be there, slow enough for the eyes.")]
        float _glideSeconds = 0.4f;

        BodyFollowing _following;

        /// <summary>The transform to follow; null if there is none.</summary>
        internal Transform Head => _head != null ? _head : Viewer.Head;

        internal bool IsGliding => _following.IsGliding;

        void OnEnable() => _following = default;

        void LateUpdate()
        {
            var head = Head;
            if (head == null) return;
            var place = transform;
            var before = new Pose(place.position, place.rotation);
            var after = _following.Next(
                before, new Pose(head.position, head.rotation),
                new FollowSettings(_distanceMetres, _degreesBelow, _turnDegrees, _moveMetres, _glideSeconds), Time.unscaledDeltaTime);
            if (after != before) place.SetPositionAndRotation(after.position, after.rotation);
        }
    }
}
