using Nowpose.Prefabs;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using Nowpose.UnityPlayer;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Rendering;

public sealed class FontTextureTests
{
    Player _player;
    Material _font;
    MeshRenderer _renderer;

    [SetUp]
    public void Begin()
    {
        _player = new Player();
        _font = new Material((Shader)null) { mainTexture = new Texture2D(256, 256) };
        var text = new GameObject("Text");
        text.SetActive(false);
        _renderer = text.AddComponent<MeshRenderer>();
        text.AddComponent<TextMesh>();
        text.AddComponent<FontTexture>().With("_fontMaterial", _font);
    }

    [TearDown]
    public void End() => _player.Dispose();

    Texture Shown
    {
        get
        {
            var block = new MaterialPropertyBlock();
            _renderer.GetPropertyBlock(block);
            return block.GetTexture("_MainTex");
        }
    }

    [Test]
    public void OnEnable_FontMaterialAssigned_SetsItsTexture()
    {
        _renderer.gameObject.SetActive(true);

        Assert.That(Shown, Is.SameAs(_font.mainTexture));
    }

    [Test]
    public void LateUpdate_FontReplacesItsTexture_SetsTheNewTexture()
    {
        _renderer.gameObject.SetActive(true);

        _font.mainTexture = new Texture2D(512, 512);
        _player.Step(0.1);

        Assert.That(Shown, Is.SameAs(_font.mainTexture));
    }

    [Test]
    public void OnEnable_PropertyBlockWithOtherProperties_KeepsThem()
    {
        var block = new MaterialPropertyBlock();
        block.SetFloat("_Own", 7);
        _renderer.SetPropertyBlock(block);

        _renderer.gameObject.SetActive(true);

        _renderer.GetPropertyBlock(block);
        Assert.That(block.GetFloat("_Own"), Is.EqualTo(7));
    }

    [Test]
    public void OnEnable_NoFontMaterial_LogsAnError()
    {
        _renderer.GetComponent<FontTexture>().With("_fontMaterial", null);

        _renderer.gameObject.SetActive(true);

        Assert.That(_player.Logs.Single().Message, Is.EqualTo("[Nowpose] " + ComponentMessages.NoFontMaterial(_renderer.name)));
    }

    [Test]
    public void Instantiate_TextWithFontTexture_CopyHasTheTexture()
    {
        var copy = UnityEngine.Object.Instantiate(_renderer.gameObject);
        copy.SetActive(true);

        var block = new MaterialPropertyBlock();
        copy.GetComponent<MeshRenderer>().GetPropertyBlock(block);
        Assert.That(block.GetTexture("_MainTex"), Is.SameAs(_font.mainTexture));
    }
}
