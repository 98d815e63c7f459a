using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Engine.Rendering;

public sealed class MeshTests : PlayerFixture
{
    [TestCase(3)]
    [TestCase(-1)]
    public void Triangles_BeyondTheVertices_AreRefused(int index)
    {
        var mesh = Triangle();

        Assert.That(() => mesh.triangles = [0, 1, index], Throws.ArgumentException.With.Message.Contains($"Index {index}"));
        Assert.That(() => mesh.triangles = [0, 1], Throws.ArgumentException);
    }

    [Test]
    public void MeshArrays_Read_AreCopies()
    {
        var mesh = Triangle();
        mesh.vertices[0] = Vector3.one;

        Assert.That(mesh.vertices[0], Is.EqualTo(Vector3.zero));
    }

    [Test]
    public void MeshBounds_AnyMesh_ContainAllVertices() => Assert.That(
        Triangle().bounds, Is.EqualTo(new Bounds(new Vector3(0.0005f, 0.001f, 0), new Vector3(0.001f, 0.002f, 0))));

    [Test]
    public void RendererBounds_MovedObject_AreInTheWorld()
    {
        var cube = GameObject.CreatePrimitive(PrimitiveType.Cube);
        cube.transform.SetPositionAndRotation(Vector3.right, Quaternion.Euler(0, 45, 0));

        var bounds = cube.GetComponent<Renderer>().bounds;

        Assert.That(bounds.center, Is.EqualTo(Vector3.right));
        Assert.That(bounds.size.x, Is.EqualTo(Math.Sqrt(2)).Within(1e-5));
        Assert.That(bounds.size.y, Is.EqualTo(1).Within(1e-5));
    }

    static Mesh Triangle() => new()
    {
        vertices = [Vector3.zero, new Vector3(0, 0.002f, 0), new Vector3(0.001f, 0, 0)],
        triangles = [0, 1, 2],
    };
}
