using Nowpose.Unity;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Anchoring;

/// <summary>Tests a base anchor that displays the pose at another scale.</summary>
public class UncheckedBaseTests
{
    PlayedBaseAnchor _played;

    [SetUp]
    public void Begin() => _played = new PlayedBaseAnchor();

    [TearDown]
    public void End() => _played.Dispose();

    [TestCase(1f, true, 0)]
    [TestCase(0.5f, false, 0)]
    [TestCase(0.5f, true, 1)]
    public void Scale_OfAParent_IsLoggedOnceIfThereAreMarkers(float scale, bool hasMarkers, int logged)
    {
        _played.Session.transform.localScale = scale * Vector3.one;
        if (hasMarkers) _played.PlayOne();
        else _played.Session.gameObject.SetActive(true);

        _played.Cell.Run(2, _played.Session);

        var words = BaseMessages.Scaled(_played.Anchor.transform.lossyScale);
        Assert.That(_played.Logged.Count(message => message.EndsWith(words)), Is.EqualTo(logged));
    }
}
