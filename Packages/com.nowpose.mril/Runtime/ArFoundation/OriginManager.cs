using System;
using System.Collections.Generic;
using Unity.XR.CoreUtils;
using UnityEngine;
using UnityEngine.XR;
using UnityEngine.XR.ARFoundation;

namespace Nowpose.ArFoundation
{
    /// <summary>A manager of AR Foundation on the XR Origin's object: found there, or put there, and watched.</summary>
    /// <remarks>Allocates only when something changes.</remarks>
    sealed class OriginManager<T> where T : MonoBehaviour
    {
        /// <summary>While the scene and the runtime start nothing is wrong yet.</summary>
        const float PatienceSeconds = 3;

        static readonly List<XRDisplaySubsystem> Displays = new List<XRDisplaySubsystem>();

        /// <summary>Nothing real is known to be so near to where the device's session began.</summary>
        const float OriginMetres = 0.001f;

        readonly Func<T, ISubsystem> _subsystemOf;
        readonly bool _isAdded;
        readonly string _need;
        OriginFault _fault;
        XROrigin _origin;
        float? _since;
        bool _wasDisplaying, _isOurs;

        /// <param name="subsystemOf">What the device's runtime does the manager's work with; null where it offers none.</param>
        /// <param name="isAdded">Whether a missing one is added; false where it needs what only the user can give it.</param>
        /// <param name="need">What the manager is for and what the user has to see to, for a message.</param>
        public OriginManager(Func<T, ISubsystem> subsystemOf, bool isAdded, string need)
        {
            _subsystemOf = subsystemOf;
            _isAdded = isAdded;
            _need = need;
        }

        /// <summary>Null where there is none.</summary>
        public T Manager { get; private set; }

        /// <summary>Whether it works: what it knows is as of this frame.</summary>
        public bool IsRunning { get; private set; }

        /// <summary>Why it does not work, in one line; null when nothing is wrong, or while everything starts.</summary>
        public string Problem { get; private set; }

        /// <summary>Once a frame.</summary>
        /// <param name="assigned">Null: the origin above the main camera.</param>
        /// <returns>Whether <see cref="Problem"/> is another one than before.</returns>
        public bool Follow(XROrigin assigned)
        {
            if (Manager == null)
            {
                Manager = FindOrAdd(assigned);
                _origin = Manager != null ? Manager.GetComponent<XROrigin>() : null;
            }
            var subsystem = Manager != null ? _subsystemOf(Manager) : null;
            IsRunning = Manager != null && Manager.isActiveAndEnabled && subsystem != null && subsystem.running;
            if (Manager != null && subsystem == null) TryAgainWhenXrStarts();
            var fault = FaultOf(assigned, subsystem);
            if (fault == OriginFault.None) _since = null;
            else if (Time.unscaledTime - (_since ??= Time.unscaledTime) < PatienceSeconds) return false;
            if (fault == _fault) return false;
            _fault = fault;
            Problem = WordsOf(fault);
            return true;
        }

        /// <summary>Whether a pose of the device's is the origin of its session, where devices put what they do not know.</summary>
        /// <remarks>In the session's own space: in the world that is where the XR Origin has it.</remarks>
        /// <param name="world">Where it is in the scene, metres.</param>
        public bool IsSessionOrigin(Vector3 world)
        {
            var space = _origin != null ? _origin.TrackablesParent : null;
            return space != null && space.InverseTransformPoint(world).magnitude < OriginMetres;
        }

        /// <summary>Lets the device rest, unless the manager is the user's; <see cref="Wake"/> undoes it.</summary>
        public void Sleep()
        {
            IsRunning = false;
            if (_isOurs && Manager != null) Manager.enabled = false;
        }

        public void Wake()
        {
            if (_isOurs && Manager != null) Manager.enabled = true;
        }

        T FindOrAdd(XROrigin assigned)
        {
            var origin = OriginOr(assigned);
            if (origin == null) return null;
            var found = origin.GetComponent<T>();
            _isOurs = found == null && _isAdded;
            return _isOurs ? origin.gameObject.AddComponent<T>() : found;
        }

        // A manager looks for its subsystem only when it is enabled; XR may begin later.
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

        OriginFault FaultOf(XROrigin assigned, ISubsystem subsystem)
        {
            if (Manager == null) return OriginOr(assigned) == null ? OriginFault.NoOrigin : OriginFault.NoManager;
            if (!Manager.isActiveAndEnabled) return OriginFault.SwitchedOff;
            if (subsystem == null) return OriginFault.NotOffered;
            return ARSession.state == ARSessionState.None ? OriginFault.NoSession : OriginFault.None;
        }

        static XROrigin OriginOr(XROrigin assigned)
        {
            if (assigned != null) return assigned;
            var camera = Camera.main;
            return camera != null ? camera.GetComponentInParent<XROrigin>() : null;
        }

        string WordsOf(OriginFault fault)
        {
            switch (fault)
            {
                case OriginFault.NoOrigin: return "no XR Origin is above the main camera; add one, or assign it";
                case OriginFault.NoManager: return "the XR Origin has no " + typeof(T).Name + "; add one to it: " + _need;
                case OriginFault.SwitchedOff: return "the " + typeof(T).Name + " on the XR Origin is switched off";
                case OriginFault.NotOffered: return "the device's XR runtime offers none, or does not run: " + _need;
                case OriginFault.NoSession: return "no AR Session is in the scene; add one (XR > AR Session)";
                default: return null;
            }
        }
    }
}
