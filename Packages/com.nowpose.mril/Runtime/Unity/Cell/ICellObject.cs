using Nowpose.Session;

namespace Nowpose.Unity.Cell
{
    /// <summary>A component that shows an object at a frame of the cell. The object's look shows the state of the frame.</summary>
    interface ICellObject
    {
        /// <summary>Whether the object is shown where it is at the display time, and otherwise why not.</summary>
        PoseState State { get; }

        /// <summary>Whether it is shown where it is in the scene, because it has neither been placed by hand nor by a source.</summary>
        bool IsUnplaced { get; }
    }
}
