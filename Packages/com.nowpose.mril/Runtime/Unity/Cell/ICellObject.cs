using Nowpose.Session;
using UnityEngine;

namespace Nowpose.Unity.Cell
{
    /// <summary>A component that shows an object at a frame of the cell. The appearance of the object shows the state of the frame.</summary>
    interface ICellObject
    {
        /// <summary>
        /// State that the object's look shows, see <see cref="SettledPose"/>. If the object is not shown where it is at the display time, the state
        /// gives the reason.
        /// </summary>
        PoseState SettledState { get; }

        /// <summary>
        /// The transform that is the frame <c>world</c> for this object; null while the object follows no frame, equal to null if it was destroyed.
        /// </summary>
        Transform World { get; }

        /// <summary>Whether the object is still at its pose from the scene, because neither the user nor a source has placed it.</summary>
        bool IsUnplaced { get; }

        /// <summary>Whether the object's pose is known and is the same at any time.</summary>
        bool IsFixed { get; }
    }
}
