using UnityEngine.XR.ARSubsystems;

namespace Nowpose.ArFoundation
{
    /// <summary>Saves AR Foundation's anchors over restarts of the application, for <see cref="ArSpatialAnchors"/> on the same object.</summary>
    /// <remarks>Call it on the frame's thread only; it never throws.</remarks>
    public interface IAnchorStore
    {
        /// <summary>Whether the store has reported the names of its anchors.</summary>
        bool IsReady { get; }

        /// <summary>Why the store is not ready, or the last failure, in one line; null unless there is a problem.</summary>
        string Problem { get; }

        bool Has(string name);

        /// <summary>Starts to load an anchor; the anchor manager lists it among its trackables later.</summary>
        /// <returns>Id of the trackable; <see cref="TrackableId.invalidId"/> if the anchor cannot be loaded.</returns>
        TrackableId Load(string name);

        /// <summary>Saves an anchor under a name and replaces the previous anchor of that name.</summary>
        bool TryKeep(TrackableId anchor, string name);

        /// <summary>Deletes the anchor of that name; does nothing if there is none.</summary>
        void Forget(string name);
    }
}
