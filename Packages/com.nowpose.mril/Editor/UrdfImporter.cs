using System;
using System.IO;
using System.Linq;
using Nowpose.Editor.Import;
using Nowpose.Editor.Messages;
using Nowpose.Kinematics;
using Nowpose.Unity;
using Nowpose.Unity.Robot;
using UnityEditor.AssetImporters;
using UnityEngine;

namespace Nowpose.Editor
{
    /// <summary>
    /// Imports a .urdf file as a prefab with the links, their visuals, and a Robot Rig and a Pose Appearance at the root. Adds the robot description
    /// as a sub-asset.
    /// </summary>
    [ScriptedImporter(Version, "urdf", AfterModels)]
    public sealed class UrdfImporter : ScriptedImporter
    {
        // Increase this number when the import of an unchanged file gives a different result. Unity then imports all files again.
        const int Version = 2;

        // Position in Unity's import order: after textures, shaders and models, to which a URDF refers, and before prefabs (1500), which may refer
        // to a URDF.
        const int AfterModels = 1100;

        const long MaxFileBytes = 16L << 20;

        [SerializeField, Tooltip("Material of the links up to the flange. Choose an occluder if the real arm should hide the objects behind it. "
            + "Empty: the colours of the URDF and the materials of the models.")]
        Material _armMaterial = null;

        [SerializeField, Tooltip("Material of the links that the flange carries. Empty: the colours of the URDF and the materials of the models.")]
        Material _toolMaterial = null;

        public override void OnImportAsset(AssetImportContext ctx)
        {
            try
            {
                var text = Read(ctx.assetPath);
                Import(ctx, text, UrdfReader.Read(text, Path.GetFileName(ctx.assetPath)));
            }
            catch (Exception fault) when (fault is InputException || fault is IOException || fault is UnauthorizedAccessException)
            {
                ctx.LogImportError(fault.Message);
            }
        }

        void Import(AssetImportContext ctx, string text, RobotModel model)
        {
            var name = Path.GetFileNameWithoutExtension(ctx.assetPath);
            var robot = new GameObject(name);
            robot.AddComponent<RobotRig>();
            // The materials of models cannot fade. Without a substitute, the parts would be hidden while the pose is not current.
            robot.AddComponent<PoseAppearance>().Substitute = Hologram(ctx);
            RigBuilder.Build(model, robot.transform, new ImportedLook(ctx, _armMaterial, _toolMaterial));
            ctx.AddObjectToAsset("robot", robot);
            ctx.SetMainObject(robot);
            ctx.AddObjectToAsset("description", RobotDescriptionAsset.Create(name, text));
        }

        static Material Hologram(AssetImportContext ctx)
        {
            var path = PackageAsset.Hologram.Path;
            if (path.Length > 0) ctx.DependsOnArtifact(path);
            return PackageAsset.Hologram.Load<Material>();
        }

        static string Read(string assetPath)
        {
            var path = ProjectFiles.FullPath(assetPath);
            var length = new FileInfo(path).Length;
            if (length > MaxFileBytes)
                throw new InputException(MeshMessages.UrdfTooLong(Path.GetFileName(assetPath), length, MaxFileBytes));
            return File.ReadAllText(path);
        }

        // Unity calls this method by name before an import, and imports the returned files first. OnImportAsset reports the errors.
        internal static string[] GatherDependenciesFromSourceFile(string path)
        {
            try
            {
                var locator = ProjectFiles.LocatorFor(path);
                return UrdfReader.Read(Read(path), path).Links
                    .SelectMany(link => link.Visuals).Where(visual => visual.MeshFile != null)
                    .Select(visual => locator.Find(visual.MeshFile).Path).Where(mesh => mesh != null && MeshSource.IsModel(mesh))
                    .Distinct().ToArray();
            }
            catch (Exception fault) when (fault is InputException || fault is IOException || fault is UnauthorizedAccessException)
            {
                return Array.Empty<string>();
            }
        }
    }
}
