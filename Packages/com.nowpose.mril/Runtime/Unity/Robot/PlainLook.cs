using Nowpose.Kinematics;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>Two materials and no meshes: those lie in files that a headset does not have.</summary>
    /// <remarks>Colours come from the materials alone, for on an additive display a dark one is invisible.</remarks>
    sealed class PlainLook : IRigLook
    {
        readonly Material _arm, _tool;
        Material _unitys;

        /// <param name="arm">Of the links up to the flange; null for what Unity gives its primitives.</param>
        /// <param name="tool">Of the links that the flange carries; null for the same.</param>
        public PlainLook(Material arm, Material tool)
        {
            _arm = arm;
            _tool = tool;
        }

        /// <summary>Whether a material was asked for that it was not given.</summary>
        public bool LacksMaterial { get; private set; }

        public Material MaterialOf(VisualColour? colour, bool isTool)
        {
            var material = isTool ? _tool : _arm;
            if (material != null) return material;
            if (!LacksMaterial) _unitys = TakenFromAPrimitive();
            LacksMaterial = true;
            return _unitys;
        }

        public GameObject MeshOf(LinkVisual visual, bool isTool) => null;

        // What has no material at all is magenta; and a script can have Unity's default in no other way.
        static Material TakenFromAPrimitive()
        {
            var cube = GameObject.CreatePrimitive(PrimitiveType.Cube);
            cube.SetActive(false);
            var material = cube.GetComponent<MeshRenderer>().sharedMaterial;
            if (Application.isPlaying) Object.Destroy(cube);
            else Object.DestroyImmediate(cube);
            return material;
        }
    }
}
