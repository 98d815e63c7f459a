using UnityEngine.XR.ARSubsystems;

namespace Nowpose.ArFoundation
{
    /// <summary>Keeps AR Foundation's anchors over restarts of the application, for <see cref="ArSpatialAnchors"/> on the same object.</summary>
    /// <remarks>Belongs to the frame's thread; never throws.</remarks>
    public interface IAnchorStore
    {
        /// <summary>Whether it is known by now what was kept.</summary>
        bool IsReady { get; }

        /// <summary>Why it is not ready, or what failed last, in one line; null when nothing is wrong.</summary>
        string Problem { get; }

        bool Has(string name);

        /// <summary>Begins to load an anchor, which the anchor manager has among its trackables later.</summary>
        /// <returns>Its id there; <see cref="TrackableId.invalidId"/> when it cannot be loaded.</returns>
        TrackableId Load(string name);

        /// <summary>Keeps an anchor under a name, in place of what was kept under it.</summary>
        bool TryKeep(TrackableId anchor, string name);

        /// <summary>Does nothing when nothing is kept under it.</summary>
        void Forget(string name);
    }
}
