using System;
using System.Collections.Generic;
using System.IO;
using Nowpose.Editor.Messages;
using UnityEditor;
using UnityEditor.AssetImporters;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Nowpose.Editor.Import
{
    /// <summary>Supplies the meshes that a URDF names, and declares that the import of the URDF depends on them.</summary>
    /// <remarks>Logs one warning for each file that cannot be used. The rest of the robot is still imported.</remarks>
    sealed class MeshSource
    {
        readonly AssetImportContext _context;
        readonly MeshLocator _locator;
        readonly Dictionary<string, Mesh> _stlMeshes = new Dictionary<string, Mesh>(StringComparer.Ordinal);
        readonly HashSet<string> _failed = new HashSet<string>(StringComparer.Ordinal);

        public MeshSource(AssetImportContext context)
        {
            _context = context;
            _locator = ProjectFiles.LocatorFor(context.assetPath);
        }

        /// <summary>Creates an object that shows a mesh in the visual's frame, in Unity's axes.</summary>
        /// <param name="name">Name of the file as in the URDF.</param>
        /// <param name="material">Material of the mesh if the file is an STL, or if <paramref name="replacesMaterials"/> is true.</param>
        /// <param name="replacesMaterials">Whether the material replaces the materials that a model file contains.</param>
        /// <returns>Null if the mesh cannot be used.</returns>
        public GameObject Show(string name, Material material, bool replacesMaterials)
        {
            if (_failed.Contains(name)) return null;
            try
            {
                var path = Found(name);
                if (IsStl(path)) return ShowStl(path, material);
                return ShowModel(path, replacesMaterials ? material : null);
            }
            catch (Exception fault) when (fault is InputException || fault is IOException || fault is UnauthorizedAccessException)
            {
                _failed.Add(name);
                _context.LogImportWarning(Path.GetFileName(_context.assetPath) + ": " + fault.Message);
                return null;
            }
        }

        /// <summary>Returns whether Unity itself imports files of this format. The URDF importer then uses the result of Unity's import.</summary>
        public static bool IsModel(string path)
        {
            var extension = Path.GetExtension(path).ToLowerInvariant();
            return extension == ".obj" || extension == ".dae" || extension == ".fbx";
        }

        static bool IsStl(string path) => Path.GetExtension(path).Equals(".stl", StringComparison.OrdinalIgnoreCase);

        string Found(string name)
        {
            var mesh = _locator.Find(name);
            if (mesh.Path == null)
            {
                foreach (var candidate in mesh.Candidates) _context.DependsOnSourceAsset(candidate);
                throw new InputException(MeshMessages.Of(mesh.Fault));
            }
            if (IsStl(mesh.Path) || IsModel(mesh.Path)) return mesh.Path;
            throw new InputException(MeshMessages.Format(name));
        }

        GameObject ShowStl(string path, Material material)
        {
            if (!_stlMeshes.TryGetValue(path, out var mesh))
            {
                _context.DependsOnSourceAsset(path);
                var triangles = StlReader.ReadFile(ProjectFiles.FullPath(path), path);
                mesh = StlMesh.Build(triangles, Path.GetFileNameWithoutExtension(path));
                _context.AddObjectToAsset("mesh " + path, mesh);
                _stlMeshes.Add(path, mesh);
            }
            var shown = new GameObject();
            shown.AddComponent<MeshFilter>().sharedMesh = mesh;
            shown.AddComponent<MeshRenderer>().sharedMaterial = material;
            return shown;
        }

        GameObject ShowModel(string path, Material material)
        {
            _context.DependsOnArtifact(path);
            var model = AssetDatabase.LoadAssetAtPath<GameObject>(path);
            if (model == null) throw new InputException(MeshMessages.NotImported(path));
            var turn = TurnOf(path);
            var shown = new GameObject();
            var axes = new GameObject("axes").transform;
            axes.SetParent(shown.transform, worldPositionStays: false);
            axes.localRotation = turn;
            Adapt(Object.Instantiate(model, axes, worldPositionStays: false), material);
            return shown;
        }

        static Quaternion TurnOf(string path) =>
            Path.GetExtension(path).Equals(".dae", StringComparison.OrdinalIgnoreCase) && ModelAxes.TurnsColladaByItself()
                ? Quaternion.identity
                : ModelAxes.ToRobot(ModelHeader.UpAxisOf(ProjectFiles.FullPath(path)));

        // Removes cameras and lights, which a model may contain, and renames its objects, because a rig finds its links by name.
        static void Adapt(GameObject instance, Material material)
        {
            foreach (var behaviour in instance.GetComponentsInChildren<Behaviour>(true)) Object.DestroyImmediate(behaviour);
            foreach (var part in instance.GetComponentsInChildren<Transform>(true)) part.name = MeshName(part.GetSiblingIndex());
            if (material == null) return;
            foreach (var renderer in instance.GetComponentsInChildren<Renderer>(true))
            {
                var materials = renderer.sharedMaterials;
                for (var i = 0; i < materials.Length; i++) materials[i] = material;
                renderer.sharedMaterials = materials;
            }
        }

        // Siblings must have different names, because Unity identifies the objects in an imported file by their hierarchy paths.
        static string MeshName(int index) => index == 0 ? "mesh" : "mesh " + (index + 1);
    }
}
