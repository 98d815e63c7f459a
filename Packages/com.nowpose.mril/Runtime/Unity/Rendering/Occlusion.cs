using System.Collections.Generic;
using UnityEngine;

namespace Nowpose.Unity.Rendering
{
    /// <summary>Controls the parts of a cell that write depth at the real arm: if on, they hide virtual objects behind the arm.</summary>
    /// <remarks>Applies to displayed rigs only; identifies the parts by their material, including those of a robot that a rig builds later.</remarks>
    sealed class Occlusion
    {
        readonly List<RobotRig> _rigs = new List<RobotRig>();
        readonly List<MeshRenderer> _found = new List<MeshRenderer>();
        readonly List<MeshRenderer> _hidden = new List<MeshRenderer>();
        Material _material;

        public bool IsOn { get; private set; } = true;

        /// <param name="material">Null for the arm material of each rig.</param>
        public void Begin(MrilSession session, Material material)
        {
            _material = material;
            session.GetComponentsInChildren(true, _rigs);
            _rigs.RemoveAll(rig => rig.Shows != RigPose.Displayed);
            foreach (var rig in _rigs) rig.Bound += Apply;
            Apply();
        }

        /// <summary>Ends the control and shows all hidden parts.</summary>
        public void End()
        {
            Show();
            foreach (var rig in _rigs)
                if (rig is object) rig.Bound -= Apply;
            _rigs.Clear();
        }

        public void Set(bool isOn)
        {
            IsOn = isOn;
            Apply();
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
