using System;
using System.Collections.Generic;
using Nowpose.Unity.Messages;
using Unity.XR.CoreUtils;
using UnityEngine;
using UnityEngine.XR;
using UnityEngine.XR.ARFoundation;

namespace Nowpose.ArFoundation
{
    /// <summary>Finds or adds an AR Foundation manager on the XR Origin's object, and reports why it does not work.</summary>
    /// <remarks>After its construction, allocates only when it adds a manager.</remarks>
    sealed class OriginManager<T> where T : MonoBehaviour
    {
        /// <summary>Delay before a problem is reported. The scene and the runtime take some time to start.</summary>
        const float ReportDelaySeconds = 3;

        static readonly List<XRDisplaySubsystem> Displays = new List<XRDisplaySubsystem>();

        /// <summary>Distance from the session's origin below which a pose is the device's default value and not a measurement.</summary>
        const float OriginMetres = 0.001f;

        readonly Func<T, ISubsystem> _subsystemOf;
        readonly bool _isAdded;

        // Composed once, because the problem is found again in each frame.
        readonly string _noManager, _managerOff, _notOffered, _notRunning;
        XROrigin _origin;
        double? _since;
        bool _wasDisplaying, _isOurs;

        /// <param name="subsystemOf">Returns the subsystem that the XR runtime provides for the manager; null if the runtime provides none.</param>
        /// <param name="isAdded">Whether a missing manager is added. False for a manager with settings that only the user can supply.</param>
        /// <param name="need">Requirement of the manager that the user must meet, as part of a message.</param>
        public OriginManager(Func<T, ISubsystem> subsystemOf, bool isAdded, string need)
        {
            _subsystemOf = subsystemOf;
            _isAdded = isAdded;
            _noManager = DeviceMessages.NoManager(typeof(T).Name, need);
            _managerOff = DeviceMessages.ManagerOff(typeof(T).Name);
            _notOffered = DeviceMessages.NotOffered(typeof(T).Name, need);
            _notRunning = DeviceMessages.NotRunning(typeof(T).Name);
        }

        /// <summary>The manager; null if the XR Origin has none.</summary>
        public T Manager { get; private set; }

        /// <summary>Parent of all objects of the device's session; null while the manager is unknown.</summary>
        public Transform Trackables => _origin != null ? _origin.TrackablesParent : null;

        /// <summary>Whether the manager and its subsystem run. If true, the manager's data is current in this frame.</summary>
        public bool IsRunning { get; private set; }

        /// <summary>Reason why the manager does not work, in one line; null if it works, and in the first seconds.</summary>
        [field: NonSerialized] public string Problem { get; private set; }

        /// <summary>Finds or adds the manager, and updates the other properties. Call once per frame.</summary>
        /// <param name="assigned">The XR Origin; null selects the XR Origin above the main camera in the hierarchy.</param>
        /// <returns>Whether <see cref="Problem"/> has changed.</returns>
        public bool Follow(XROrigin assigned)
        {
            if (Manager == null)
            {
                Manager = FindOrAdd(assigned);
                _origin = Manager != null ? Manager.GetComponent<XROrigin>() : null;
            }
            var subsystem = Manager != null ? _subsystemOf(Manager) : null;
            IsRunning = Manager != null && Manager.isActiveAndEnabled && subsystem != null && subsystem.running;
            if (IsRunning) _wasDisplaying = false;
            else if (Manager != null && subsystem?.running != true) TryAgainWhenXrStarts();
            var problem = ProblemOf(assigned, subsystem);
            if (problem == null) _since = null;
            else if (Time.unscaledTimeAsDouble - (_since ??= Time.unscaledTimeAsDouble) < ReportDelaySeconds) return false;
            if (problem == Problem) return false;
            Problem = problem;
            return true;
        }

        /// <summary>
        /// Returns whether a position is the origin of the device's session. Devices report this position for objects of unknown pose.
        /// </summary>
        /// <remarks>The origin of the session is not always the origin of the scene, because the XR Origin may be moved.</remarks>
        /// <param name="world">Position in the scene, in metres.</param>
        public bool IsSessionOrigin(Vector3 world)
        {
            var space = Trackables;
            return space != null && space.InverseTransformPoint(world).magnitude < OriginMetres;
        }

        /// <summary>Removes the manager if this object added it. The next <see cref="Follow"/>, also that of another object, adds it again.</summary>
        /// <returns>Whether the manager is removed. Until the end of the frame, it still has its trackables, which the caller must destroy.</returns>
        public bool Remove()
        {
            IsRunning = false;
            if (!_isOurs || Manager == null) return false;
            UnityEngine.Object.Destroy(Manager);
            return true;
        }

        T FindOrAdd(XROrigin assigned)
        {
            var origin = OriginOr(assigned);
            if (origin == null) return null;
            var found = origin.GetComponent<T>();
            _isOurs = found == null && _isAdded;
            return _isOurs ? origin.gameObject.AddComponent<T>() : found;
        }

        // A manager looks for its subsystem only in OnEnable. If XR starts later, or starts again with other subsystems, the manager must be enabled again.
        void TryAgainWhenXrStarts()
        {
            SubsystemManager.GetSubsystems(Displays);
            var isDisplaying = Displays.Count > 0 && Displays[0].running;
            if (isDisplaying && !_wasDisplaying && Manager.enabled)
            {
                Manager.enabled = false;
                Manager.enabled = true;
            }
            _wasDisplaying = isDisplaying;
        }

        string ProblemOf(XROrigin assigned, ISubsystem subsystem)
        {
            if (Manager == null) return OriginOr(assigned) == null ? DeviceMessages.NoOrigin : _noManager;
            if (!Manager.isActiveAndEnabled) return _managerOff;
            if (subsystem == null) return _notOffered;
            if (ARSession.state == ARSessionState.None) return DeviceMessages.NoArSession;
            return subsystem.running ? null : _notRunning;
        }

        static XROrigin OriginOr(XROrigin assigned)
        {
            if (assigned != null) return assigned;
            var camera = Camera.main;
            return camera != null ? camera.GetComponentInParent<XROrigin>() : null;
        }
    }
}
