using System.Collections.Generic;
using UnityEngine;

namespace Nowpose.Unity.Rendering
{
    /// <summary>Enables or disables occlusion: invisible parts at the pose of the real arm that hide the virtual objects behind the arm.</summary>
    /// <remarks>
    /// Applies only to rigs that show the displayed pose. Identifies the parts by their material, including the parts of robots built later. A rig
    /// that is added later is found at the next change.
    /// </remarks>
    sealed class Occlusion
    {
        readonly List<RobotRig> _rigs = new List<RobotRig>();
        readonly List<MeshRenderer> _found = new List<MeshRenderer>();
        readonly List<MeshRenderer> _hidden = new List<MeshRenderer>();
        MrilSession _session;
        Material _material;

        public bool IsOn { get; private set; } = true;

        /// <summary>Starts to control the parts below a session.</summary>
        /// <param name="material">Material of the parts; null to use the arm material of each rig.</param>
        public void Begin(MrilSession session, Material material)
        {
            (_session, _material) = (session, material);
            session.GetComponentsInChildren(true, _rigs);
            _rigs.RemoveAll(rig => rig.Shows != RigPose.Displayed);
            foreach (var rig in _rigs) rig.Bound += Apply;
            Apply();
        }

        /// <summary>Stops controlling the parts, and enables all parts that this object has disabled.</summary>
        public void End()
        {
            Show();
            foreach (var rig in _rigs)
                if (rig is object) rig.Bound -= Apply;
            _rigs.Clear();
            _session = null;
        }

        public void Set(bool isOn)
        {
            IsOn = isOn;
            var session = _session;
            End();
            if (session != null) Begin(session, _material);
        }

        void Apply()
        {
            Show();
            if (IsOn) return;
            foreach (var rig in _rigs)
                if (rig != null) Hide(rig);
        }

        void Hide(RobotRig rig)
        {
            var material = _material != null ? _material : rig.ArmMaterial;
            if (material == null) return;
            rig.GetComponentsInChildren(true, _found);
            foreach (var each in _found)
            {
                if (!each.enabled || each.sharedMaterial != material) continue;
                each.enabled = false;
                _hidden.Add(each);
            }
        }

        void Show()
        {
            foreach (var each in _hidden)
                if (each != null) each.enabled = true;
            _hidden.Clear();
        }
    }
}
