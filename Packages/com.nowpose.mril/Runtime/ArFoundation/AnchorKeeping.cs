using Nowpose.Unity.Messages;
using UnityEngine;
using UnityEngine.XR.ARSubsystems;

namespace Nowpose.ArFoundation
{
    /// <summary>Saves one anchor in the store as soon as a store is ready, and retries if the store refuses it.</summary>
    sealed class AnchorKeeping
    {
        const int MaxAttempts = 10;

        /// <summary>Interval between attempts. A store may accept an anchor only after the device has mapped more of the room.</summary>
        const float TryEverySeconds = 1;

        readonly ArSpatialAnchors _owner;
        readonly ArSpatialAnchor _anchor;
        string _wanted;
        double _next;
        int _tries;

        public AnchorKeeping(ArSpatialAnchors owner, ArSpatialAnchor anchor)
        {
            _owner = owner;
            _anchor = anchor;
        }

        /// <summary>Name under which the store holds the anchor; null while the anchor is not saved.</summary>
        public string KeptAs { get; set; }

        /// <summary>Reason why the anchor is not saved; null if no problem is known.</summary>
        public string Problem { get; private set; }

        public void Keep(string name)
        {
            Problem = AnchorNames.FaultOf(name);
            if (Problem != null) return;
            if (_owner.Store == null)
            {
                Problem = DeviceMessages.NoStoreComponent;
                return;
            }
            _wanted = name == KeptAs ? null : name;
            _tries = 0;
            _next = 0;
        }

        public void RemoveName(string name)
        {
            if (KeptAs == name) KeptAs = null;
            if (_wanted == name) _wanted = null;
        }

        /// <summary>Tries to save the anchor if a save is pending. Call once per frame while the device tracks the anchor.</summary>
        public void Follow(TrackableId id)
        {
            if (_wanted == null || Time.unscaledTimeAsDouble < _next) return;
            if (!_owner.IsReady)
            {
                Problem = _owner.StoreProblem;
                return;
            }
            var store = _owner.Store;
            _next = Time.unscaledTimeAsDouble + TryEverySeconds;
            if (store.TryKeep(id, _wanted)) Kept();
            else if (++_tries < MaxAttempts) Problem = DeviceMessages.NotStoredYet;
            else GiveUp(store);
        }

        void Kept()
        {
            Problem = null;
            KeptAs = _wanted;
            _owner.RemoveName(_wanted, _anchor);
            _wanted = null;
        }

        void GiveUp(IAnchorStore store)
        {
            Problem = DeviceMessages.NotStored(_wanted, store.Problem);
            _wanted = null;
        }
    }
}
