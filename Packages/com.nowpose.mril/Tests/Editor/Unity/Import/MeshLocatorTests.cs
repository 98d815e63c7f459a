using System;
using System.Linq;
using Nowpose.Editor;
using Nowpose.Editor.Import;
using Nowpose.Editor.Messages;
using NUnit.Framework;

namespace Nowpose.Tests.Unity.Import
{
    public class MeshLocatorTests
    {
        const string Urdf = "Assets/Robots/arm_description/urdf/arm.urdf";

        [TestCase("meshes/a.stl", "Assets/Robots/arm_description/urdf/meshes/a.stl")]
        [TestCase("./meshes//a.stl", "Assets/Robots/arm_description/urdf/meshes/a.stl")]
        [TestCase("../meshes/a.stl", "Assets/Robots/arm_description/meshes/a.stl")]
        [TestCase(@"..\meshes\a.stl", "Assets/Robots/arm_description/meshes/a.stl")]
        [TestCase("package://arm_description/meshes/a.stl", "Assets/Robots/arm_description/meshes/a.stl")]
        [TestCase("Package://arm_description/meshes/a.stl", "Assets/Robots/arm_description/meshes/a.stl")]
        [TestCase("model://arm_description/meshes/a.stl", "Assets/Robots/arm_description/meshes/a.stl")]
        [TestCase("package://other/a.stl", "Assets/Robots/arm_description/urdf/other/a.stl")]
        [TestCase("package://other/a.stl", "Assets/Robots/arm_description/other/a.stl")]
        [TestCase("package://other/a.stl", "Assets/Robots/other/a.stl")]
        [TestCase("package://other/a.stl", "Assets/other/a.stl")]
        [TestCase("package://other/a.stl", "Packages/other/a.stl")]
        [TestCase("file:///projects/project/Assets/a.stl", "Assets/a.stl")]
        [TestCase("/projects/project/Assets/a.stl", "Assets/a.stl")]
        public void Find_ExistingFile_ReturnsItsPath(string name, string path)
        {
            var found = Locator(path).Find(name);

            Assert.That(found.Path, Is.EqualTo(path));
            Assert.That(found.Fault, Is.Null);
        }

        [Test]
        public void Find_FileUriWithADrive_ReturnsItsPath()
        {
            var locator = new MeshLocator(Urdf, @"C:\me\project", path => path == "Assets/a.stl");

            Assert.That(locator.Find("file:///C:/me/project/Assets/a.stl").Path, Is.EqualTo("Assets/a.stl"));
        }

        [Test]
        public void Find_PackageInTwoPlaces_ReturnsTheNearest()
        {
            var found = Locator("Assets/other/a.stl", "Assets/Robots/other/a.stl").Find("package://other/a.stl");

            Assert.That(found.Path, Is.EqualTo("Assets/Robots/other/a.stl"));
        }

        [Test]
        public void Find_UrdfInAPackage_SearchesAssets()
        {
            var locator = new MeshLocator("Packages/com.me.robots/urdf/arm.urdf", "/projects/project", path => path == "Assets/arm/a.stl");

            Assert.That(locator.Find("package://arm/a.stl").Path, Is.EqualTo("Assets/arm/a.stl"));
        }

        [Test]
        public void Find_MissingFile_NamesAllPlacesOnce()
        {
            var found = Locator().Find("package://other/meshes/a.stl");

            Assert.That(found.Path, Is.Null);
            Assert.That(found.Candidates, Is.EqualTo(new[]
            {
                "Assets/Robots/arm_description/urdf/other/meshes/a.stl",
                "Assets/Robots/arm_description/other/meshes/a.stl",
                "Assets/Robots/other/meshes/a.stl",
                "Assets/other/meshes/a.stl",
                "Packages/other/meshes/a.stl",
            }));
            Assert.That(found.Fault, Is.EqualTo(MeshMessages.NotFound("package://other/meshes/a.stl", string.Join(", ", found.Candidates))));
        }

        [TestCase("../../../../a.stl", MeshMessages.Outside)]
        [TestCase("../../../../../a.stl", MeshMessages.Outside)]
        [TestCase("/projects/meshes/a.stl", MeshMessages.Outside)]
        [TestCase("/projects/project/Library/a.stl", MeshMessages.Outside)]
        [TestCase("/projects/project/Assets/../../a.stl", MeshMessages.Outside)]
        [TestCase("D:/meshes/a.stl", MeshMessages.Outside)]
        [TestCase("http://example.org/a.stl", MeshMessages.Scheme)]
        [TestCase("package://other", MeshMessages.NoFileInPackage)]
        [TestCase("package://other/", MeshMessages.NoFileInPackage)]
        [TestCase("package:///a.stl", MeshMessages.NoFileInPackage)]
        [TestCase("$(find other)/a.stl", MeshMessages.Xacro)]
        public void Find_PathOutsideTheProject_ReturnsTheFault(string name, string fault)
        {
            var found = new MeshLocator(Urdf, "/projects/project", path => true).Find(name);

            Assert.That(found.Path, Is.Null);
            Assert.That(found.Fault, Is.EqualTo("'" + name + "' " + fault));
        }

        static MeshLocator Locator(params string[] files) =>
            new MeshLocator(Urdf, "/projects/project/", path => files.Contains(path, StringComparer.Ordinal));
    }
}
