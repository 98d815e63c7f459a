using UnityEngine.XR.ARSubsystems;

namespace Nowpose.ArFoundation
{
    /// <summary>
    /// Saves AR Foundation's anchors across restarts of the application. <see cref="ArSpatialAnchors"/> on the same object uses it.
    /// </summary>
    /// <remarks>Members are called on Unity's main thread only, and must not throw.</remarks>
    public interface IAnchorStore
    {
        /// <summary>Whether the store is open, so the names of its anchors are available.</summary>
        bool IsReady { get; }

        /// <summary>Reason why the store is not ready, or the last failure, in one line; null if no problem is known.</summary>
        string Problem { get; }

        bool Has(string name);

        /// <summary>Starts loading an anchor. The anchor manager later lists the anchor among its trackables.</summary>
        /// <returns>Id of the trackable; <see cref="TrackableId.invalidId"/> if the anchor cannot be loaded.</returns>
        TrackableId Load(string name);

        /// <summary>Saves an anchor under a name, and replaces any earlier anchor of that name.</summary>
        /// <returns>False if the store refused the anchor.</returns>
        bool TryKeep(TrackableId anchor, string name);

        /// <summary>Deletes the anchor with this name; does nothing if the store has no such anchor.</summary>
        void Forget(string name);
    }
}
