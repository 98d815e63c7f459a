using System;
using System.Collections.Generic;
using Nowpose.Kinematics;
using Nowpose.Unity;
using Nowpose.Unity.Robot;
using UnityEditor.AssetImporters;
using UnityEngine;

namespace Nowpose.Editor.Import
{
    /// <summary>Supplies the materials of an imported robot: those that the user has chosen, or materials in the colours of the URDF.</summary>
    sealed class ImportedLook : IRigLook
    {
        static readonly VisualColour Uncoloured = new VisualColour(0.8, 0.8, 0.8, 1);

        readonly AssetImportContext _context;
        readonly MeshSource _meshes;
        readonly Material _arm, _tool;
        readonly Dictionary<string, Material> _materials = new Dictionary<string, Material>(StringComparer.Ordinal);
        Shader _shader;

        /// <param name="arm">Material of the links up to the flange; null for the colours of the URDF.</param>
        /// <param name="tool">Material of the links that the flange carries; null for the colours of the URDF.</param>
        public ImportedLook(AssetImportContext context, Material arm, Material tool)
        {
            _context = context;
            _meshes = new MeshSource(context);
            _arm = arm;
            _tool = tool;
        }

        public Material MaterialOf(VisualColour? colour, bool isTool)
        {
            var chosen = Chosen(isTool);
            return chosen != null ? chosen : OfColour(colour ?? Uncoloured);
        }

        public GameObject MeshOf(LinkVisual visual, bool isTool) =>
            _meshes.Show(visual.MeshFile, MaterialOf(visual.Colour, isTool), replacesMaterials: Chosen(isTool) != null);

        Material Chosen(bool isTool) => isTool ? _tool : _arm;

        Material OfColour(VisualColour colour)
        {
            var bytes = new Color32(Byte(colour.Red), Byte(colour.Green), Byte(colour.Blue), Byte(colour.Alpha));
            var name = "#" + bytes.r.ToString("x2") + bytes.g.ToString("x2") + bytes.b.ToString("x2") + bytes.a.ToString("x2");
            if (_materials.TryGetValue(name, out var known)) return known;
            var material = new Material(HologramShader()) { name = name, color = bytes };
            _context.AddObjectToAsset("material " + name, material);
            _materials.Add(name, material);
            return material;
        }

        Shader HologramShader()
        {
            if (_shader != null) return _shader;
            var path = PackageAsset.HologramShader.Path;
            if (path.Length > 0) _context.DependsOnArtifact(path);
            _shader = PackageAsset.HologramShader.Load<Shader>();
            return _shader != null ? _shader : _shader = Shader.Find("Standard");
        }

        static byte Byte(double part) => (byte)Math.Round(255 * Math.Min(1, Math.Max(0, part)));
    }
}
