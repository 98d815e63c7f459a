using System.Collections.Generic;
using Nowpose.Anchoring;
using Nowpose.Kinematics;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Session;
using Unity.XR.CoreUtils;
using UnityEngine;
using UnityEngine.XR.ARFoundation;
using UnityEngine.XR.ARSubsystems;

namespace Nowpose.ArFoundation
{
    /// <summary>Holds positions in the room as anchors of AR Foundation. Saves the anchors across restarts if the same object has a store.</summary>
    [AddComponentMenu("Nowpose/Spatial Anchors")]
    [DisallowMultipleComponent]
    public sealed class ArSpatialAnchors : MonoBehaviour, ISpatialAnchors
    {
        [SerializeField, Tooltip("The XR Origin. The component adds an AR Anchor Manager if it has none. Empty: the XR Origin above the main "
            + "camera.")]
        XROrigin _origin = null;

        readonly OriginManager<ARAnchorManager> _manager = new OriginManager<ARAnchorManager>(
            manager => manager.subsystem, isAdded: true, DeviceMessages.AnchorNeeds);

        readonly List<ArSpatialAnchor> _anchors = new List<ArSpatialAnchor>();
        readonly List<string> _unwanted = new List<string>();
        IAnchorStore _store;

        /// <summary>Reason why the device cannot create or save anchors, in one line; null if no problem is known.</summary>
        public string Problem => _manager.Problem ?? StoreProblem;

        public bool IsReady => !IsStoreOff && (Store?.IsReady ?? false);

        /// <summary>Reason why the store saves no anchors, in one line; null if no problem is known.</summary>
        internal string StoreProblem => IsStoreOff ? DeviceMessages.StoreOff : Store?.Problem;

        bool IsStoreOff => Store is Behaviour store && !store.enabled;

        internal ARAnchorManager Manager => _manager.Manager;

        /// <summary>Whether this component runs. While a hierarchy is being activated, isActiveAndEnabled may still be false.</summary>
        internal bool IsOn => enabled && gameObject.activeInHierarchy;

        internal bool IsRunning => _manager.IsRunning;

        internal Transform Trackables => _manager.Trackables;

        internal bool IsSessionOrigin(Vector3 world) => _manager.IsSessionOrigin(world);

        /// <summary>The store on the same object; null if it does not exist or was destroyed. It may be added after this component.</summary>
        internal IAnchorStore Store => IsThere(_store) || TryGetComponent(out _store) ? _store : null;

        public ISpatialAnchor Hold(in RigidTransform pose) => Add(new ArSpatialAnchor(this, UnityPoses.ToWorld(pose), pose));

        public ISpatialAnchor Find(string name)
        {
            if (!IsReady || AnchorNames.FaultOf(name) != null || !Store.Has(name)) return null;
            var id = Store.Load(name);
            return id == TrackableId.invalidId ? null : Add(new ArSpatialAnchor(this, id, name));
        }

        public void Forget(string name)
        {
            if (AnchorNames.FaultOf(name) != null) return;
            RemoveName(name, null);
            if (IsReady) Store.Forget(name);
            else _unwanted.Add(name);
        }

        /// <summary>
        /// Removes a name from all anchors except <paramref name="keeper"/>. The store now uses the name for that anchor, or does not use it.
        /// </summary>
        internal void RemoveName(string name, ArSpatialAnchor keeper)
        {
            // Cancels a pending deletion of this name: the name is in use again.
            _unwanted.Remove(name);
            foreach (var anchor in _anchors)
                if (anchor != keeper) anchor.RemoveName(name);
        }

        /// <returns>True if no other object uses the same anchor of the device.</returns>
        internal bool Remove(ArSpatialAnchor anchor)
        {
            _anchors.Remove(anchor);
            foreach (var other in _anchors)
                if (other.IsOf(anchor)) return false;
            return true;
        }

        void OnDestroy()
        {
            while (_anchors.Count > 0) _anchors[_anchors.Count - 1].Dispose();
        }

        void Update()
        {
            if (_manager.Follow(_origin) && _manager.Problem != null)
                ConsoleLog.Warn(this, ComponentMessages.Of("spatial anchors", name, _manager.Problem));
            if (_unwanted.Count > 0 && IsReady) ForgetUnwanted();
            foreach (var anchor in _anchors) anchor.Follow();
        }

        void ForgetUnwanted()
        {
            foreach (var name in _unwanted) Store.Forget(name);
            _unwanted.Clear();
        }

        static bool IsThere(IAnchorStore store) => store is Object component && component != null;

        ArSpatialAnchor Add(ArSpatialAnchor anchor)
        {
            _anchors.Add(anchor);
            return anchor;
        }
    }
}
