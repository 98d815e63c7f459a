using System;
using System.Collections.Generic;
using System.Threading.Tasks;
using Microsoft.MixedReality.OpenXR;
using Microsoft.MixedReality.OpenXR.ARFoundation;
using Nowpose.ArFoundation;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Session;
using UnityEngine;
using UnityEngine.XR.ARSubsystems;

namespace Nowpose.OpenXR
{
    /// <summary>
    /// Saves spatial anchors across restarts in the anchor store of Windows Mixed Reality. Needs Microsoft's Mixed Reality OpenXR plugin.
    /// </summary>
    [AddComponentMenu("Nowpose/Anchor Store")]
    [DisallowMultipleComponent]
    [RequireComponent(typeof(ArSpatialAnchors))]
    public sealed class OpenXrAnchorStore : MonoBehaviour, IAnchorStore
    {
        /// <summary>Interval between attempts to open the store. The plugin has no store before its session runs.</summary>
        const float AskEverySeconds = 1;

        const int AttemptsBeforeReport = 5;

        const string SpareEnding = " (new)";

        ArSpatialAnchors _anchors;
        Task<XRAnchorStore> _loading;
        XRAnchorStore _store;
        XRAnchorSubsystem _of;
        double _next;
        int _asked;

        public bool IsReady => _store != null;

        [field: NonSerialized] public string Problem { get; private set; }

        public bool Has(string name) => Try("look for '" + name + "'", store => StoredAs(store, name) != null);

        public TrackableId Load(string name)
        {
            var id = TrackableId.invalidId;
            Try("load '" + name + "'", store =>
            {
                id = store.LoadAnchor(StoredAs(store, name) ?? name);
                return true;
            });
            return id;
        }

        public bool TryKeep(TrackableId anchor, string name) => Try("keep '" + name + "'", store =>
        {
            if (store.TryPersistAnchor(anchor, name)) return true;
            // The store does not save an anchor if its name is already in use. In that case, saves it under a spare name, so that the earlier anchor
            // with this name is removed only if the store accepts the new one.
            if (!IsAmong(store.PersistedAnchorNames, name)) return false;
            var spare = name + SpareEnding;
            if (IsAmong(store.PersistedAnchorNames, spare)) store.UnpersistAnchor(spare);
            if (!store.TryPersistAnchor(anchor, spare)) return false;
            store.UnpersistAnchor(name);
            if (store.TryPersistAnchor(anchor, name)) store.UnpersistAnchor(spare);
            return true;
        });

        public void Forget(string name) => Try("forget '" + name + "'", store =>
        {
            foreach (var stored in new[] { name, name + SpareEnding })
                if (IsAmong(store.PersistedAnchorNames, stored)) store.UnpersistAnchor(stored);
            return true;
        });

        void OnEnable() => _anchors = GetComponent<ArSpatialAnchors>();

        void Update()
        {
            var manager = _anchors.Manager;
            var subsystem = manager != null ? manager.subsystem : null;
            if (subsystem != _of) Restart(subsystem);
            if (_store != null || subsystem == null) return;
            if (_loading != null) Take();
            else if (_anchors.IsRunning && Time.unscaledTimeAsDouble >= _next) Ask();
        }

        // The runtime has restarted, so the old store is no longer valid.
        void Restart(XRAnchorSubsystem subsystem)
        {
            _of = subsystem;
            _store = null;
            _loading = null;
            _asked = 0;
            _next = 0;
        }

        void Ask()
        {
            _next = Time.unscaledTimeAsDouble + AskEverySeconds;
            _asked++;
            try
            {
                _loading = _anchors.Manager.LoadAnchorStoreAsync();
                // Observes the task's exception, because no other code does if this component is destroyed before the task fails.
                _loading.ContinueWith(Observe, TaskContinuationOptions.OnlyOnFaulted | TaskContinuationOptions.ExecuteSynchronously);
            }
            catch (Exception fault)
            {
                Fail(DeviceMessages.LoadAnchors, fault);
            }
        }

        void Take()
        {
            if (!_loading.IsCompleted) return;
            var loading = _loading;
            _loading = null;
            if (loading.Status == TaskStatus.RanToCompletion && loading.Result != null)
            {
                _store = loading.Result;
                Problem = null;
            }
            else if (loading.Exception != null) Fail(DeviceMessages.LoadAnchors, loading.Exception.GetBaseException());
            else if (_asked == AttemptsBeforeReport) Report(DeviceMessages.NoAnchorStore);
        }

        // Catches all exceptions: the plugin calls native code of the operating system, and does not document what it throws.
        bool Try(string what, Func<XRAnchorStore, bool> action)
        {
            if (_store == null) return false;
            try
            {
                return action(_store);
            }
            catch (Exception fault)
            {
                Fail(what, fault);
                return false;
            }
        }

        static void Observe(Task loading) => _ = loading.Exception;

        // Returns the name under which the store has an anchor: its own or the spare one; null if it has none.
        static string StoredAs(XRAnchorStore store, string name) =>
            IsAmong(store.PersistedAnchorNames, name) ? name : IsAmong(store.PersistedAnchorNames, name + SpareEnding) ? name + SpareEnding : null;

        static bool IsAmong(IReadOnlyList<string> names, string name)
        {
            for (var i = 0; i < (names?.Count ?? 0); i++)
                if (names[i] == name) return true;
            return false;
        }

        void Fail(string what, Exception fault) => Report(DeviceMessages.StoreFailed(what, fault.Message));

        void Report(string problem)
        {
            if (problem == Problem) return;
            Problem = problem;
            ConsoleLog.Warn(this, ComponentMessages.Of("anchor store", name, problem));
        }
    }
}
