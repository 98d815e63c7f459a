using System.Collections;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Runtime.CompilerServices;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Tests.Unity
{
    /// <summary>Checks the package's assets as imported by the project that uses the package.</summary>
    public class ShippedAssetsTests
    {
        const string Runtime = "Packages/com.nowpose.mril/Runtime/";

        /// <summary>References that may be empty because the component has a fallback.</summary>
        static readonly string[] MayBeEmpty =
        {
            "VirtualGripper._rig", "PoseAppearance._session", "PoseAppearance._words", "BodyFollow._head", "LatencyProfileLoader._shipped",
            "StatusPanel._bar", "RobotRig._description",
        };

        static IEnumerable<string> Prefabs => Files("Prefabs", "prefab");
        static IEnumerable<string> Materials => Files("Materials", "mat");
        static IEnumerable<string> Robots => Files("Robots", "asset");

        /// <summary>
        /// Returns the asset paths as Unity uses them. The folder is relative to this source file, so the package can be installed anywhere.
        /// </summary>
        static IEnumerable<string> Files(string folder, string extension) =>
            Directory.GetFiles(FullPath(folder), "*." + extension).Select(file => Runtime + folder + "/" + Path.GetFileName(file));

        static string FullPath(string folder, [CallerFilePath] string here = "") =>
            Path.Combine(Path.GetDirectoryName(here), "..", "..", "..", "Runtime", folder);

        [Test]
        public void Files_OfEachKind_AreFound()
        {
            Assert.That(Prefabs.Count(), Is.EqualTo(6));
            Assert.That(Materials.Count(), Is.EqualTo(10));
            Assert.That(Robots.Count(), Is.EqualTo(6));
        }

        [TestCaseSource("Prefabs")]
        public void Prefab_Loaded_HasItsScriptsAndReferences(string path)
        {
            var prefab = AssetDatabase.LoadAssetAtPath<GameObject>(path);

            Assert.That(prefab, Is.Not.Null, path);
            var components = prefab.GetComponentsInChildren<Component>(true);
            Assert.That(components.All(component => component != null), Is.True, "a script is missing");
            foreach (var filter in components.OfType<MeshFilter>()) Assert.That(filter.sharedMesh != null, Is.True, filter.name + " has no mesh");
            foreach (var renderer in components.OfType<Renderer>())
            {
                Assert.That(renderer.sharedMaterial != null, Is.True, renderer.name + " has no material");
                Assert.That(renderer.sharedMaterial.shader.name, Does.StartWith("Nowpose/"), renderer.name);
            }
            var empty = components.OfType<MonoBehaviour>().SelectMany(c => Empty(c, c.GetType().Name + ".")).Except(MayBeEmpty);
            // Another robot uses the session above it.
            var expected = path.Contains("Any Robot") ? "MrilSession._robot" : path.EndsWith("/Nowpose Robot.prefab") ? "RobotRig._session" : "";
            Assert.That(string.Join(", ", empty), Is.EqualTo(expected));
        }

        [TestCaseSource("Materials")]
        public void Material_Loaded_HasAShaderOfThePackage(string path)
        {
            var material = AssetDatabase.LoadAssetAtPath<Material>(path);

            Assert.That(material, Is.Not.Null, path);
            Assert.That(material.shader != null, Is.True, "no shader");
            Assert.That(material.shader.name, Does.StartWith("Nowpose/"));
            if (path.EndsWith("/Occluder.mat") || path.EndsWith("/Text.mat")) return;
            Assert.That(material.HasProperty("_Fade"), Is.True);
            Assert.That(material.HasProperty("_Hatch"), Is.True);
        }

        [TestCaseSource("Robots")]
        public void Robot_Loaded_IsValid(string path)
        {
            var asset = AssetDatabase.LoadAssetAtPath<RobotDescriptionAsset>(path);

            Assert.That(asset, Is.Not.Null, path);
            Assert.That(asset.Read().MovingJoints.Count, Is.GreaterThan(5));
        }

        [Test]
        public void Settings_Loaded_AreAccepted()
        {
            var asset = AssetDatabase.LoadAssetAtPath<SessionSettingsAsset>(Runtime + "Settings/Default Session Settings.asset");

            Assert.That(asset, Is.Not.Null);
            Assert.DoesNotThrow(() => asset.ToSettings());
        }

        /// <summary>Returns the names of the serialised references that are null or missing.</summary>
        static IEnumerable<string> Empty(object owner, string prefix)
        {
            foreach (var field in owner.GetType().GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic))
            {
                if (field.GetCustomAttribute<SerializeField>() == null) continue;
                var value = field.GetValue(owner);
                if (typeof(Object).IsAssignableFrom(field.FieldType))
                {
                    if ((Object)value == null) yield return prefix + field.Name;
                }
                else if (value is IList items)
                {
                    foreach (var item in items)
                        foreach (var name in Empty(item, prefix + field.Name + ".")) yield return name;
                }
            }
        }
    }
}
