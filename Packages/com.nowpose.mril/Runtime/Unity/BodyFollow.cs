using Nowpose.Unity.Status;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>
    /// Keeps an object in front of the wearer. The object stays in place until the head has turned or moved too far; then it glides to a new
    /// place in front of the wearer. The object is always upright.
    /// </summary>
    [AddComponentMenu("Nowpose/Body Follow")]
    [DefaultExecutionOrder(MrilSession.ExecutionOrder + 1)]
    [DisallowMultipleComponent]
    public sealed class BodyFollow : MonoBehaviour
    {
        [SerializeField, Tooltip("The object to follow. Empty: the main camera, which is the wearer's head.")]
        Transform _head = null;

        [SerializeField, Range(0.3f, 5), Tooltip("Distance from the head in metres. Default 1.3: a headset's image is sharp from about "
            + "half a metre on.")]
        float _distanceMetres = 1.3f;

        [SerializeField, Range(-30, 45), Tooltip("Angle below eye level in degrees. Default 6: the whole status panel is in the view of a "
            + "HoloLens 2.")]
        float _degreesBelow = 6;

        [SerializeField, Range(5, 90), Tooltip("Maximum rotation of the head to either side in degrees before the object follows. Default 35: "
            + "looking along a robot does not move the object.")]
        float _turnDegrees = 35;

        [SerializeField, Range(0.05f, 2), Tooltip("Maximum movement of the head in metres, in any direction, before the object follows. Default "
            + "0.4: shifting the weight from one foot to the other does not move the object.")]
        float _moveMetres = 0.4f;

        [SerializeField, Range(0.05f, 2), Tooltip("Time constant of the movement in seconds. Default 0.4: fast enough to arrive soon, and slow "
            + "enough to watch.")]
        float _glideSeconds = 0.4f;

        BodyFollowing _following;

        /// <summary>The transform to follow; null if no head is assigned and the scene has no main camera.</summary>
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
